// SPDX-License-Identifier: MIT
// Box3D: its defaults, 4 sub-steps of its soft step, its own threads. Not default: no sleeping. The friction
// coefficient of a pair is the root of the product of the two bodies', so each body gets the scene's. Joints:
// spherical and revolute as they are; what they join does not collide.
//
// It has no half space: a plane is the top of a box that reaches well beyond the bodies.
#include <box3d/box3d.h>

#include <algorithm>

#include "sim/base/error.h"
#include "sim/body/compound.h"
#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "tests/bench/peers/engine.h"

namespace pabd::peers {

namespace {

constexpr int kSubSteps = 4;
constexpr double kGroundDepth = 10;    // half the thickness of the box below a plane; m
constexpr double kGroundMargin = 100;  // how far it reaches beyond the bodies' start; m

template <class Vector = b3Vec3>
Vector to_box3d(const Vec3& v) {
  using Scalar = decltype(Vector::x);
  return {static_cast<Scalar>(v.x()), static_cast<Scalar>(v.y()), static_cast<Scalar>(v.z())};
}
template <class Vector>
Vec3 from_box3d(const Vector& v) {
  return {v.x, v.y, v.z};
}

b3Quat to_quat(const Mat3& R) {
  const Quat q(R);
  return {to_box3d(Vec3(q.vec())), static_cast<float>(q.w())};
}
Mat3 from_quat(const b3Quat& q) { return Quat(q.s, q.v.x, q.v.y, q.v.z).normalized().toRotationMatrix(); }

// Adds a scene's shapes to bodies.
class ShapeMaker {
 public:
  ShapeMaker(double friction, double ground_reach) : ground_reach_(ground_reach) {
    def_.baseMaterial.friction = static_cast<float>(friction);
    def_.baseMaterial.restitution = 0;
  }

  void add(b3BodyId body, const Shape& shape) const {
    if (const Box* box = std::get_if<Box>(&shape)) {
      add_box(body, box->half);
    } else if (const Sphere* sphere = std::get_if<Sphere>(&shape)) {
      const b3Sphere copy{b3Vec3_zero, static_cast<float>(sphere->radius)};
      b3CreateSphereShape(body, &def_, &copy);
    } else if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
      const Vec3 end(0, 0.5 * capsule->length, 0);
      const b3Capsule copy{to_box3d(Vec3(-end)), to_box3d(end), static_cast<float>(capsule->radius)};
      b3CreateCapsuleShape(body, &def_, &copy);
    } else if (std::holds_alternative<Plane>(shape)) {
      add_box(body, {ground_reach_, kGroundDepth, ground_reach_});
    } else if (const Hull* hull = std::get_if<Hull>(&shape)) {
      add_hull(body, *hull, Vec3::Zero());
    } else if (const Compound* compound = std::get_if<Compound>(&shape)) {
      for (const CompoundPart& part : compound->data->parts) add_hull(body, part.hull(), part.offset);
    }
  }

 private:
  void add_box(b3BodyId body, const Vec3& half) const {
    const b3Vec3 h = to_box3d(half);
    const b3BoxHull box = b3MakeBoxHull(h.x, h.y, h.z);
    b3CreateHullShape(body, &def_, &box.base);
  }

  void add_hull(b3BodyId body, const Hull& hull, const Vec3& offset) const {
    std::vector<b3Vec3> points;
    for (const Vec3& vertex : hull.data->vertices) points.push_back(to_box3d(Vec3(offset + vertex)));
    const auto count = static_cast<int>(points.size());
    b3HullData* made = count <= B3_MAX_HULL_VERTICES ? b3CreateHull(points.data(), count, count) : nullptr;
    if (!made) {
      throw Error(ErrorKind::bad_input,
                  "Box3D adapter: expected hulls that Box3D takes, of 128 vertices or "
                  "fewer");
    }
    b3CreateHullShape(body, &def_, made);
    b3DestroyHull(made);
  }

  b3ShapeDef def_ = b3DefaultShapeDef();
  double ground_reach_;
};

// Farthest body's centre from the origin at the start, planes left out.
double farthest(const Scene& scene) {
  double reach = 0;
  for (Index i = 0; i < scene.model.size(); ++i) {
    if (!std::holds_alternative<Plane>(scene.model.shape[i]))
      reach = std::max(reach, scene.initial.c[i].norm() + bounding_radius(scene.model.shape[i]));
  }
  return reach;
}

class Box3dEngine : public Engine {
 public:
  Box3dEngine(const Scene& scene, int threads)
      : h_(static_cast<float>(scene.params.h)), initial_(scene.initial), fixed_(scene.model.fixed) {
    b3WorldDef def = b3DefaultWorldDef();
    def.gravity = to_box3d(scene.params.gravity);
    def.enableSleep = false;
    def.workerCount = static_cast<std::uint32_t>(threads);
    world_ = b3CreateWorld(&def);
    try {
      const ShapeMaker shapes(scene.params.contact.mu_dynamic, farthest(scene) + kGroundMargin);
      for (Index i = 0; i < scene.model.size(); ++i) add_body(scene, static_cast<std::size_t>(i), shapes);
      const b3BodyDef still = b3DefaultBodyDef();
      ground_ = b3CreateBody(world_, &still);
      for (const Joint& joint : scene.model.joints) add_joint(joint);
    } catch (...) {
      b3DestroyWorld(world_);
      throw;
    }
  }

  ~Box3dEngine() override { b3DestroyWorld(world_); }

  void step() override { b3World_Step(world_, h_, kSubSteps); }

  void penetrations(std::vector<double>& out) const override {
    out.clear();
    std::vector<b3ContactData> contacts;
    for (const b3BodyId body : bodies_) {
      contacts.resize(static_cast<std::size_t>(b3Body_GetContactCapacity(body)));
      const int count = b3Body_GetContactData(body, contacts.data(), static_cast<int>(contacts.size()));
      contacts.resize(static_cast<std::size_t>(count));
      for (const b3ContactData& contact : contacts) {
        // Both bodies know a contact; it counts for the first.
        if (B3_ID_EQUALS(b3Shape_GetBody(contact.shapeIdA), body)) add_depths(contact, out);
      }
    }
  }

  void read(State& state) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (fixed_[i]) {  // a plane's box is not where the plane is
        state.c[i] = initial_.c[i];
        state.R[i] = initial_.R[i];
        state.v[i].setZero();
        state.omega[i].setZero();
        continue;
      }
      state.c[i] = from_box3d(b3Body_GetPosition(bodies_[i]));
      state.R[i] = from_quat(b3Body_GetRotation(bodies_[i]));
      state.v[i] = from_box3d(b3Body_GetLinearVelocity(bodies_[i]));
      state.omega[i] = from_box3d(b3Body_GetAngularVelocity(bodies_[i]));
    }
  }

 private:
  void add_body(const Scene& scene, std::size_t i, const ShapeMaker& shapes) {
    Vec3 c = scene.initial.c[i];
    Mat3 R = scene.initial.R[i];
    if (const Plane* plane = std::get_if<Plane>(&scene.model.shape[i])) {
      R = rotation_between(Vec3::UnitY(), plane->normal);
      c = (plane->offset - kGroundDepth) * plane->normal;
    }
    b3BodyDef def = b3DefaultBodyDef();
    def.type = fixed_[i] ? b3_staticBody : b3_dynamicBody;
    def.position = to_box3d<b3Pos>(c);
    def.rotation = to_quat(R);
    def.linearVelocity = to_box3d(scene.initial.v[i]);
    def.angularVelocity = to_box3d(scene.initial.omega[i]);
    bodies_.push_back(b3CreateBody(world_, &def));
    shapes.add(bodies_.back(), scene.model.shape[i]);
    if (fixed_[i]) return;
    const Mat3 I = inertia_tensor(scene.model.J[i]);
    b3Body_SetMassData(bodies_.back(),
                       {static_cast<float>(scene.model.mass[i]),
                        b3Vec3_zero,
                        {to_box3d(Vec3(I.col(0))), to_box3d(Vec3(I.col(1))), to_box3d(Vec3(I.col(2)))}});
  }

  void attach(const Joint& joint, b3JointDef& def) const {
    const auto body = [this](Index k) {
      return k == kWorld ? ground_ : bodies_[static_cast<std::size_t>(k)];
    };
    // Box3D's hinge turns about the third column of its frames, ours about the first.
    const auto frame = [](const JointFrame& from) -> b3Transform {
      Mat3 F;
      F << from.F.col(1), from.F.col(2), from.F.col(0);
      return {to_box3d(from.r), to_quat(F)};
    };
    def.bodyIdA = body(joint.i);
    def.bodyIdB = body(joint.j);
    def.localFrameA = frame(joint.on_i);
    def.localFrameB = frame(joint.on_j);
  }

  void add_joint(const Joint& joint) {
    const bool plain = !joint.limits && !joint.drive && !joint.turn;
    if (plain && joint.type == JointType::spherical) {
      b3SphericalJointDef def = b3DefaultSphericalJointDef();
      attach(joint, def.base);
      b3CreateSphericalJoint(world_, &def);
    } else if (plain && joint.type == JointType::hinge) {
      b3RevoluteJointDef def = b3DefaultRevoluteJointDef();
      attach(joint, def.base);
      b3CreateRevoluteJoint(world_, &def);
    } else {
      throw Error(ErrorKind::bad_input, "Box3D adapter: expected spherical joints and hinges without limits");
    }
  }

  static void add_depths(const b3ContactData& contact, std::vector<double>& out) {
    for (int m = 0; m < contact.manifoldCount; ++m) {
      const b3Manifold& manifold = contact.manifolds[m];
      for (int k = 0; k < manifold.pointCount; ++k) {
        const double d = manifold.points[k].separation;
        if (d < 0) out.push_back(-d);
      }
    }
  }

  float h_;
  const State& initial_;
  const std::vector<std::uint8_t>& fixed_;
  b3WorldId world_;
  b3BodyId ground_;  // the world, for joints
  std::vector<b3BodyId> bodies_;
};

}  // namespace

std::string engine_name() {
  const b3Version version = b3GetVersion();
  return "Box3D " + std::to_string(version.major) + "." + std::to_string(version.minor) + "." +
         std::to_string(version.revision) + PABD_BOX3D_REVISION;
}

int engine_threads() { return B3_MAX_WORKERS; }

bool engine_takes(SceneFor scene) { return scene != SceneFor::us_alone; }

std::unique_ptr<Engine> make_engine(const Scene& scene, const EngineOptions& options) {
  return std::make_unique<Box3dEngine>(scene, options.threads);
}

}  // namespace pabd::peers
