// SPDX-License-Identifier: MIT
// Bullet: btDiscreteDynamicsWorld as its "hello world" sets it up (dynamic AABB trees, sequential impulses,
// 10 iterations). Not default: no sleeping. The friction coefficient of a pair is the product of the two
// bodies' coefficients, so each body gets the root. Joints: btPoint2PointConstraint and btHingeConstraint as
// they are; what they join does not collide.
#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "sim/base/error.h"
#include "sim/body/mass_properties.h"
#include "tests/bench/peers/engine.h"

namespace pabd::peers {

namespace {

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

std::unique_ptr<btCollisionShape> make_shape(const Shape& shape) {
  if (const Box* box = std::get_if<Box>(&shape)) return std::make_unique<btBoxShape>(to_bullet(box->half));
  if (const Sphere* sphere = std::get_if<Sphere>(&shape))
    return std::make_unique<btSphereShape>(static_cast<btScalar>(sphere->radius));
  if (const Plane* plane = std::get_if<Plane>(&shape))
    return std::make_unique<btStaticPlaneShape>(to_bullet(plane->normal),
                                                static_cast<btScalar>(plane->offset));
  throw Error(ErrorKind::bad_input, "Bullet adapter: expected boxes, spheres and planes");
}

btTransform make_frame(const Mat3& R, const Vec3& origin) {
  btMatrix3x3 basis;
  for (int row = 0; row < 3; ++row) basis[row] = to_bullet(R.row(row).transpose());
  return btTransform(basis, to_bullet(origin));
}

// Bullet's hinge turns about the third column of its frames, ours about the first.
btTransform hinge_frame(const JointFrame& frame) {
  Mat3 F;
  F << frame.F.col(1), frame.F.col(2), frame.F.col(0);
  return make_frame(F, frame.r);
}

std::unique_ptr<btTypedConstraint> make_joint(const Joint& joint, btRigidBody& a, btRigidBody& b) {
  const bool plain = !joint.limits && !joint.drive && !joint.turn;
  if (plain && joint.type == JointType::spherical)
    return std::make_unique<btPoint2PointConstraint>(a, b, to_bullet(joint.on_i.r), to_bullet(joint.on_j.r));
  if (plain && joint.type == JointType::hinge)
    return std::make_unique<btHingeConstraint>(a, b, hinge_frame(joint.on_i), hinge_frame(joint.on_j));
  throw Error(ErrorKind::bad_input, "Bullet adapter: expected spherical joints and hinges without limits");
}

class BulletEngine : public Engine {
 public:
  explicit BulletEngine(const Scene& scene) : h_(static_cast<btScalar>(scene.params.h)) {
    world_.setGravity(to_bullet(scene.params.gravity));
    const auto root_mu = static_cast<btScalar>(std::sqrt(scene.params.contact.mu_dynamic));
    for (Index i = 0; i < scene.model.size(); ++i) {
      shapes_.push_back(make_shape(scene.model.shape[i]));
      const bool fixed = scene.model.fixed[i] != 0;
      // Principal axes are the body axes for all shapes above.
      const Vec3 inertia = fixed ? Vec3::Zero() : Vec3(inertia_tensor(scene.model.J[i]).diagonal());
      btRigidBody::btRigidBodyConstructionInfo info(
          fixed ? btScalar(0) : static_cast<btScalar>(scene.model.mass[i]), nullptr, shapes_.back().get(),
          to_bullet(inertia));
      info.m_startWorldTransform = make_frame(scene.initial.R[i], scene.initial.c[i]);
      info.m_friction = root_mu;
      info.m_restitution = 0;
      bodies_.push_back(std::make_unique<btRigidBody>(info));
      btRigidBody& body = *bodies_.back();
      body.setLinearVelocity(to_bullet(scene.initial.v[i]));
      body.setAngularVelocity(to_bullet(scene.initial.omega[i]));
      if (!fixed) body.setActivationState(DISABLE_DEACTIVATION);
      world_.addRigidBody(&body);
    }
    const auto body = [this](Index k) -> btRigidBody& {
      return k == kWorld ? btTypedConstraint::getFixedBody() : *bodies_[static_cast<std::size_t>(k)];
    };
    for (const Joint& joint : scene.model.joints) {
      joints_.push_back(make_joint(joint, body(joint.i), body(joint.j)));
      world_.addConstraint(joints_.back().get(), true);
    }
  }

  ~BulletEngine() override {
    for (auto& joint : joints_) world_.removeConstraint(joint.get());
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  void step() override { world_.stepSimulation(h_, 0); }

  void penetrations(std::vector<double>& out) const override {
    out.clear();
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(m);
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const double d = manifold->getContactPoint(k).getDistance();
        if (d < 0) out.push_back(-d);
      }
    }
  }

  void read(State& state) const override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const btTransform& pose = bodies_[i]->getWorldTransform();
      state.c[i] = from_bullet(pose.getOrigin());
      for (int row = 0; row < 3; ++row) state.R[i].row(row) = from_bullet(pose.getBasis()[row]).transpose();
      state.v[i] = from_bullet(bodies_[i]->getLinearVelocity());
      state.omega[i] = from_bullet(bodies_[i]->getAngularVelocity());
    }
  }

 private:
  btScalar h_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace

std::string engine_name() {
  return "Bullet " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

int engine_threads() { return 1; }

bool engine_takes(SceneFor scene) { return scene != SceneFor::us_alone; }

std::unique_ptr<Engine> make_engine(const Scene& scene, const EngineOptions&) {
  return std::make_unique<BulletEngine>(scene);
}

}  // namespace pabd::peers
