// SPDX-License-Identifier: MIT
// ODE: dWorldQuickStep (20 iterations, the world's own ERP and CFM), hash space, up to 8 contacts a pair. The
// contact mode dContactApprox1 makes `mu` a coefficient of friction; without it ODE takes it as a force in N.
// Joints: dJointTypeBall and dJointTypeHinge as they are; what they join does not collide.
//
// With PABD_ODE_DENSE a second program is made: dWorldStep, which factors one dense matrix of all joints and
// contacts of an island, for scenes where that is not out of reach.
#include <ode/ode.h>

#include "sim/base/error.h"
#include "sim/body/mass_properties.h"
#include "tests/bench/peers/engine.h"

namespace pabd::peers {

namespace {

constexpr int kPairContacts = 8;

void to_ode(const Mat3& R, dMatrix3 out) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out[4 * row + column] = R(row, column);
    out[4 * row + 3] = 0;
  }
}
Vec3 from_ode(const dReal* v) { return {v[0], v[1], v[2]}; }

dGeomID make_geom(const Shape& shape, dSpaceID space) {
  if (const Box* box = std::get_if<Box>(&shape))
    return dCreateBox(space, 2 * box->half.x(), 2 * box->half.y(), 2 * box->half.z());
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return dCreateSphere(space, sphere->radius);
  if (const Plane* plane = std::get_if<Plane>(&shape))
    return dCreatePlane(space, plane->normal.x(), plane->normal.y(), plane->normal.z(), plane->offset);
  throw Error(ErrorKind::bad_input, "ODE adapter: expected boxes, spheres and planes");
}

// The library's start and end belong to the process; one engine after the other may live in between.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
};

#ifdef PABD_ODE_DENSE
constexpr bool kDense = true;
#else
constexpr bool kDense = false;
#endif

class OdeEngine : public Engine {
 public:
  OdeEngine(const Scene& scene, bool record)
      : h_(scene.params.h), mu_(scene.params.contact.mu_dynamic), record_(record), initial_(scene.initial) {
    dRandSetSeed(0);
    world_ = dWorldCreate();
    space_ = dHashSpaceCreate(nullptr);
    contacts_ = dJointGroupCreate(0);
    const Vec3& g = scene.params.gravity;
    dWorldSetGravity(world_, g.x(), g.y(), g.z());
    dWorldSetAutoDisableFlag(world_, 0);
    for (Index i = 0; i < scene.model.size(); ++i) {
      const dGeomID geom = make_geom(scene.model.shape[i], space_);
      dBodyID body = nullptr;
      dMatrix3 R;
      to_ode(scene.initial.R[i], R);
      const Vec3 &c = scene.initial.c[i], &v = scene.initial.v[i], &w = scene.initial.omega[i];
      if (!scene.model.fixed[i]) {
        body = dBodyCreate(world_);
        const Mat3 I = inertia_tensor(scene.model.J[i]);
        dMass mass;
        dMassSetParameters(&mass, scene.model.mass[i], 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2),
                           I(1, 2));
        dBodySetMass(body, &mass);
        dGeomSetBody(geom, body);
        dBodySetPosition(body, c.x(), c.y(), c.z());
        dBodySetRotation(body, R);
        dBodySetLinearVel(body, v.x(), v.y(), v.z());
        dBodySetAngularVel(body, w.x(), w.y(), w.z());
      } else if (dGeomGetClass(geom) != dPlaneClass) {
        dGeomSetPosition(geom, c.x(), c.y(), c.z());
        dGeomSetRotation(geom, R);
      }
      bodies_.push_back(body);
    }
    for (const Joint& joint : scene.model.joints) add_joint(joint);
  }

  ~OdeEngine() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }

  void step() override {
    depths_.clear();
    dSpaceCollide(space_, this, &near);
    kDense ? dWorldStep(world_, h_) : dWorldQuickStep(world_, h_);
    dJointGroupEmpty(contacts_);
  }

  void penetrations(std::vector<double>& out) const override { out = depths_; }

  void read(State& state) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!bodies_[i]) {
        state.c[i] = initial_.c[i];
        state.R[i] = initial_.R[i];
        state.v[i].setZero();
        state.omega[i].setZero();
        continue;
      }
      state.c[i] = from_ode(dBodyGetPosition(bodies_[i]));
      state.v[i] = from_ode(dBodyGetLinearVel(bodies_[i]));
      state.omega[i] = from_ode(dBodyGetAngularVel(bodies_[i]));
      const dReal* R = dBodyGetRotation(bodies_[i]);
      for (int row = 0; row < 3; ++row) state.R[i].row(row) = from_ode(R + 4 * row).transpose();
    }
  }

 private:
  // The joint's place in the world is that of its frame on i, or on j where i is the world.
  void add_joint(const Joint& joint) {
    const bool plain = !joint.limits && !joint.drive && !joint.turn;
    const Index k = joint.i == kWorld ? joint.j : joint.i;
    const JointFrame& frame = joint.i == kWorld ? joint.on_j : joint.on_i;
    const auto index = static_cast<std::size_t>(k);
    const Vec3 place = initial_.c[index] + initial_.R[index] * frame.r;
    const Vec3 axis = initial_.R[index] * frame.F.col(0);
    const auto body = [this](Index b) {
      return b == kWorld ? nullptr : bodies_[static_cast<std::size_t>(b)];
    };
    if (plain && joint.type == JointType::spherical) {
      const dJointID id = dJointCreateBall(world_, nullptr);
      dJointAttach(id, body(joint.i), body(joint.j));
      dJointSetBallAnchor(id, place.x(), place.y(), place.z());
    } else if (plain && joint.type == JointType::hinge) {
      const dJointID id = dJointCreateHinge(world_, nullptr);
      dJointAttach(id, body(joint.i), body(joint.j));
      dJointSetHingeAnchor(id, place.x(), place.y(), place.z());
      dJointSetHingeAxis(id, axis.x(), axis.y(), axis.z());
    } else {
      throw Error(ErrorKind::bad_input, "ODE adapter: expected spherical joints and hinges without limits");
    }
  }

  static void near(void* self, dGeomID a, dGeomID b) { static_cast<OdeEngine*>(self)->collide(a, b); }

  void collide(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
    dContact contact[kPairContacts];
    const int count = dCollide(a, b, kPairContacts, &contact[0].geom, sizeof(dContact));
    for (int k = 0; k < count; ++k) {
      contact[k].surface = {};
      contact[k].surface.mode = dContactApprox1;
      contact[k].surface.mu = mu_;
      dJointAttach(dJointCreateContact(world_, contacts_, &contact[k]), body_a, body_b);
      if (record_ && contact[k].geom.depth > 0) depths_.push_back(contact[k].geom.depth);
    }
  }

  Library library_;
  dReal h_, mu_;
  bool record_;
  const State& initial_;
  dWorldID world_;
  dSpaceID space_;
  dJointGroupID contacts_;
  std::vector<dBodyID> bodies_;  // null: fixed
  std::vector<double> depths_;
};

}  // namespace

std::string engine_name() { return std::string("ODE ") + PABD_ODE_VERSION + (kDense ? " dWorldStep" : ""); }

int engine_threads() { return 1; }

bool engine_takes(SceneFor scene) { return kDense ? scene == SceneFor::dense : scene != SceneFor::us_alone; }

std::unique_ptr<Engine> make_engine(const Scene& scene, const EngineOptions& options) {
  return std::make_unique<OdeEngine>(scene, options.record_contacts);
}

}  // namespace pabd::peers
