/// Membrane forces: each term against finite differences of its energy, conservation, rigid motions and
/// closed-form limits.
#include "membrane/membrane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

#include "membrane/bending.hpp"
#include "membrane/skalak.hpp"

namespace dld {
namespace {

constexpr double radius = 3.9;
const MembraneModuli all_terms{.shear = 5.3,
                               .skalak_denominator = 12,
                               .local_area = 30,
                               .global_area = 80,
                               .volume = 100,
                               .bending = 0.2};

struct NamedModuli {
  std::string name;
  MembraneModuli moduli;
};

/// All terms together, with each law of bending.
std::vector<NamedModuli> all_terms_by_law() {
  std::vector<NamedModuli> all;
  for (const auto& known : bending_laws) {
    all.push_back({"all, " + std::string(known.name), all_terms});
    all.back().moduli.bending_law = known.law;
  }
  return all;
}

/// Every term of the energy alone, and all of them.
std::vector<NamedModuli> terms() {
  std::vector<NamedModuli> terms = all_terms_by_law();
  for (const auto& known : bending_laws)
    terms.push_back({std::string(known.name), {.bending = 0.2, .bending_law = known.law}});
  for (const auto& other : {NamedModuli{"shear", {.shear = 5.3}},
                            {"local_area", {.local_area = 30}},
                            {"global_area", {.global_area = 80}},
                            {"volume", {.volume = 100}}})
    terms.push_back(other);
  return terms;
}

/// Stretched by tens of per cent, bent, and rough on the scale of an edge.
Eigen::MatrixX3d deformed(const TriangleMesh& mesh) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> noise(-0.05, 0.05);
  Eigen::MatrixX3d x = mesh.vertices;
  for (auto p : x.rowwise()) {
    p = Eigen::RowVector3d(1.3 * p(0) + 0.1 * p(1), 0.8 * p(1), 1.1 * p(2) + 0.04 * p(0) * p(0));
    for (int k = 0; k < 3; ++k) p(k) += noise(generator);
  }
  return x;
}

TEST(Membrane, ForceIsMinusTheEnergyGradient) {
  for (const auto& [name, moduli] : terms()) {
    Membrane membrane(red_blood_cell(3, radius), moduli);
    Eigen::MatrixX3d x = deformed(membrane.reference()), f, difference(x.rows(), 3);
    membrane.forces(x, f);
    const double h = 1e-4;
    for (long i = 0; i < x.size(); ++i) {
      const double x0 = x(i);
      const auto energy_at = [&](double step) {
        x(i) = x0 + step;
        return membrane.energy(x);
      };
      // Fourth order, so that neither truncation nor rounding hides an error above 1e-8.
      difference(i) =
          -(8 * (energy_at(h) - energy_at(-h)) - (energy_at(2 * h) - energy_at(-2 * h))) / (12 * h);
      x(i) = x0;
    }
    EXPECT_GT(f.norm(), 0.1) << name;
    EXPECT_LT((f - difference).cwiseAbs().maxCoeff(), 1e-6 * f.cwiseAbs().maxCoeff()) << name;
  }
}

TEST(Membrane, ForcesAndTorquesCancel) {
  for (const auto& [name, moduli] : terms()) {
    Membrane membrane(red_blood_cell(10, radius), moduli);
    const Eigen::MatrixX3d x = deformed(membrane.reference());
    Eigen::MatrixX3d f;
    membrane.forces(x, f);
    Eigen::RowVector3d torque = Eigen::RowVector3d::Zero();
    for (long v = 0; v < x.rows(); ++v)
      torque += Eigen::RowVector3d(x.row(v)).cross(Eigen::RowVector3d(f.row(v)));
    const double scale = f.rowwise().norm().sum();
    EXPECT_GT(scale, 1.0) << name;
    EXPECT_LT(f.colwise().sum().norm(), 1e-12 * scale) << name;
    EXPECT_LT(torque.norm(), 1e-12 * scale * radius) << name;
  }
}

TEST(Membrane, RigidMotionCostsNothing) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  for (const auto& [name, moduli] : all_terms_by_law()) {
    Membrane membrane(red_blood_cell(10, radius), moduli);
    Eigen::MatrixX3d x = membrane.reference().vertices * rotation.transpose(), f;
    x.rowwise() += Eigen::RowVector3d(3, -7, 2);
    membrane.forces(x, f);
    EXPECT_LT(f.cwiseAbs().maxCoeff(), 1e-12 * all_terms.local_area * radius) << name;
    EXPECT_LT(std::abs(membrane.energy(x)), 1e-12 * all_terms.local_area * radius * radius) << name;
    const MembraneState state = membrane.measure(x);
    EXPECT_NEAR(state.area / membrane.reference_area(), 1, 1e-13) << name;
    EXPECT_NEAR(state.volume / membrane.reference_volume(), 1, 1e-13) << name;
    EXPECT_NEAR(state.min_face_ratio, 1, 1e-12) << name;
    EXPECT_LT(state.max_local_area_strain, 1e-12) << name;
  }
}

TEST(Membrane, ForcesRotateWithTheCell) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 1, 3).normalized()).toRotationMatrix();
  for (const auto& [name, moduli] : all_terms_by_law()) {
    Membrane membrane(red_blood_cell(6, radius), moduli);
    const Eigen::MatrixX3d x = deformed(membrane.reference());
    Eigen::MatrixX3d f, turned;
    membrane.forces(x, f);
    membrane.forces(x * rotation.transpose(), turned);
    EXPECT_LT((turned - f * rotation.transpose()).norm(), 1e-11 * f.norm()) << name;
  }
}

TEST(Membrane, RepeatedCallsGiveTheSameBits) {
  for (const auto& [name, moduli] : all_terms_by_law()) {
    Membrane membrane(red_blood_cell(6, radius), moduli);
    const Eigen::MatrixX3d x = deformed(membrane.reference());
    Eigen::MatrixX3d first, again, gradient;
    membrane.forces(x, first);
    membrane.volume_gradient(x, gradient);
    membrane.forces(membrane.reference().vertices, again);
    membrane.forces(x, again);
    EXPECT_TRUE(first == again) << name;
  }
}

TEST(Membrane, VolumeGradient) {
  Membrane membrane(red_blood_cell(4, radius), {});
  Eigen::MatrixX3d x = deformed(membrane.reference()), gradient;
  membrane.volume_gradient(x, gradient);
  EXPECT_LT(gradient.colwise().sum().norm(), 1e-12 * gradient.rowwise().norm().sum());
  for (long i = 0; i < x.size(); i += 7) {
    const double x0 = x(i), h = 1e-3;  // the volume is linear in one coordinate: no truncation error
    x(i) = x0 + h;
    const double above = membrane.volume(x);
    x(i) = x0 - h;
    const double below = membrane.volume(x);
    x(i) = x0;
    EXPECT_NEAR(gradient(i), (above - below) / (2 * h), 1e-9 * radius * radius);
  }
}

/// Positions as in deformed(), but their own mirror image about z = 0 and far from the origin.
Eigen::MatrixX3d deformed_symmetrically(const TriangleMesh& mesh) {
  const Eigen::VectorXi image = mirror_images(mesh.vertices);
  Eigen::MatrixX3d x = deformed(mesh);
  for (int v = 0; v < x.rows(); ++v) {
    if (mesh.vertices(v, 2) > 0) x.row(image(v)) << x(v, 0), x(v, 1), -x(v, 2);
    if (image(v) == v) x(v, 2) = 0;
  }
  x.rowwise() += Eigen::RowVector3d(40, -70, 0);
  return x;
}

/// Meshes with faces across the plane, with edges across it and with vertices on it.
TEST(MembraneForces, HalfIsWholeForASymmetricShape) {
  for (int frequency : {3, 4, 5, 10}) {
    for (const auto& [name, moduli] : terms()) {
      const Membrane membrane(red_blood_cell(frequency, radius), moduli);
      MembraneForces whole(membrane.step_forces(MirrorSymmetry::none)),
          half(membrane.step_forces(MirrorSymmetry::about_z));
      Eigen::MatrixX3d x = deformed_symmetrically(membrane.reference()), f, g, half_f, half_g;
      const AreaAndVolume all = whole.forces(x, f, g);
      // The lower half is not looked at.
      for (auto p : x.rowwise()) {
        if (p(2) < 0) p.setConstant(std::nan(""));
      }
      const AreaAndVolume twice = half.forces(x, half_f, half_g);
      EXPECT_GT(f.norm(), 0.1) << name;
      EXPECT_LT((half_f - f).cwiseAbs().maxCoeff(), 1e-12 * f.cwiseAbs().maxCoeff()) << name << frequency;
      EXPECT_LT((half_g - g).cwiseAbs().maxCoeff(), 1e-12 * g.cwiseAbs().maxCoeff()) << name << frequency;
      EXPECT_NEAR(twice.area / all.area, 1, 1e-13) << name << frequency;
      EXPECT_NEAR(twice.volume / all.volume, 1, 1e-12) << name << frequency;
    }
  }
}

TEST(MembraneForces, OnePassAgreesWithTheSeparateOnes) {
  for (const auto& [name, moduli] : all_terms_by_law()) {
    Membrane membrane(red_blood_cell(6, radius), moduli);
    const Eigen::MatrixX3d x = deformed(membrane.reference());
    Eigen::MatrixX3d f, g, f_alone, g_alone;
    const AreaAndVolume now = membrane.step_forces(MirrorSymmetry::none).forces(x, f, g);
    membrane.forces(x, f_alone);
    membrane.volume_gradient(x, g_alone);
    EXPECT_TRUE(f == f_alone) << name;
    EXPECT_TRUE(g == g_alone) << name;
    EXPECT_NEAR(now.volume / membrane.volume(x), 1, 1e-13) << name;
    EXPECT_NEAR(now.area / membrane.measure(x).area, 1, 1e-13) << name;
  }
}

TEST(MembraneForces, AMeshWithoutTheSymmetryIsRefused) {
  TriangleMesh mesh = red_blood_cell(4, radius);
  mesh.vertices(7, 0) += 1e-9;
  const Membrane membrane(mesh, all_terms);
  EXPECT_THROW(membrane.step_forces(MirrorSymmetry::about_z), std::invalid_argument);
}

/// Forces as in the textbook form: F = Ds Dm^-1, S = 2 (w1 Id + w2 adj C), [f2 f3] = -A0 F S Dm^-T.
TEST(Skalak, AgreesWithTheDeformationGradientForm) {
  const double ks = 5.3, k = 12, kalpha = 30;
  Eigen::Matrix2d dm;
  dm << 1.1, 0.3, 0, 0.9;
  const Eigen::Vector3d a(1.2, -0.2, 0.4), b(0.5, 0.8, 0.1);
  Eigen::Matrix<double, 3, 2> ds;
  ds << a, b;
  const Eigen::Matrix<double, 3, 2> gradient = ds * dm.inverse();
  const Eigen::Matrix2d c = gradient.transpose() * gradient;
  const double i1 = c.trace() - 2, i2 = c.determinant() - 1, area0 = dm.determinant() / 2;
  const double w1 = ks / k * (2 * i1 + 2), w2 = -2 * ks / k + kalpha / 6 * i2;
  const Eigen::Matrix2d adjugate = c.trace() * Eigen::Matrix2d::Identity() - c;
  const Eigen::Matrix2d s = 2 * (w1 * Eigen::Matrix2d::Identity() + w2 * adjugate);
  const Eigen::Matrix<double, 3, 2> expected = -area0 * gradient * s * dm.inverse().transpose();

  const auto ref = reference_triangle({dm(0, 0), dm(1, 0), 0}, {dm(0, 1), dm(1, 1), 0});
  const auto [f2, f3] = skalak_forces(ref, {ks / k, kalpha / 12}, 0, {a(0), a(1), a(2)}, {b(0), b(1), b(2)});
  EXPECT_LT((expected.col(0) - Eigen::Vector3d(f2.x, f2.y, f2.z)).norm(), 1e-13 * expected.norm());
  EXPECT_LT((expected.col(1) - Eigen::Vector3d(f3.x, f3.y, f3.z)).norm(), 1e-13 * expected.norm());
}

/// Pure shear with the stretches 1 + e and 1 / (1 + e) costs W = 2 G e^2; G = 4 kS / k.
TEST(Skalak, SmallStrainShearModulus) {
  const double ks = 5.3, e = 1e-4;
  for (const auto& [k, modulus] : {std::pair{12.0, ks / 3}, {8.0, ks / 2}, {4.0, ks}}) {
    const Vec3 a{1.2, 0.1, 0}, b{0.4, 0.9, 0};
    const auto stretched = [&](Vec3 v) { return Vec3{v.x * (1 + e), v.y / (1 + e), v.z}; };
    const auto ref = reference_triangle(a, b);
    const double w = skalak_energy(ref, {ks / k, 0}, stretched(a), stretched(b)) / ref.area;
    EXPECT_NEAR(w / (2 * e * e), modulus, 1e-3 * modulus) << "k = " << k;
  }
}

// The work of the principal tensions is the change of the energy: dE = A (t1 d ln l1 + t2 d ln l2), for a
// triangle that is stretched by l1 along x and l2 along y.
TEST(Skalak, TensionsDoTheWorkOfTheEnergy) {
  const Vec3 a{1.1, 0, 0}, b{0.4, 0.9, 0};
  const ReferenceTriangle ref = reference_triangle(a, b);
  const SkalakModuli moduli{5.3 / 12, 30.0 / 12};
  const auto energy = [&](double l1, double l2) {
    return skalak_energy(ref, moduli, {l1 * a.x, l2 * a.y, 0}, {l1 * b.x, l2 * b.y, 0});
  };
  for (const auto& [l1, l2] : {std::pair{1.3, 0.9}, {1.05, 1.2}, {1.0, 1.0}}) {
    const double area = ref.area * l1 * l2, h = 1e-6;
    const double t1 = (energy(l1 + h, l2) - energy(l1 - h, l2)) / (2 * h) * l1 / area;
    const double t2 = (energy(l1, l2 + h) - energy(l1, l2 - h)) / (2 * h) * l2 / area;
    const FaceTensions t =
        skalak_tensions(ref, moduli, 0.7, {l1 * a.x, l2 * a.y, 0}, {l1 * b.x, l2 * b.y, 0});
    EXPECT_NEAR(t.mean, 0.5 * (t1 + t2) + 0.7, 1e-8);
    EXPECT_NEAR(t.shear, 0.5 * std::abs(t1 - t2), 1e-7);
  }
}

TEST(Bending, Atan2) {
  for (int i = -2000; i <= 2000; ++i) {
    const double angle = i * std::numbers::pi / 2000.5;
    for (double scale : {1e-6, 1.0, 1e5}) {
      EXPECT_NEAR(branch_free_atan2(scale * std::sin(angle), scale * std::cos(angle)), angle, 2e-15);
    }
  }
  EXPECT_NEAR(branch_free_atan2(1e-9, 1.0), 1e-9, 1e-24);
}

TEST(Bending, AngleIsPositiveWhereConvex) {
  const Vec3 e{0, 1, 0}, n{-std::sin(0.3), 0, std::cos(0.3)}, m{std::sin(0.2), 0, std::cos(0.2)};
  EXPECT_NEAR(std::abs(bending_angle(e, n, m, {0, 1})), 0.5, 1e-14);
  EXPECT_NEAR(bending_angle(e, n, m, {0, 1}), -bending_angle(e, m, n, {0, 1}), 1e-15);
  const Membrane membrane(sphere(4, 1.0), {.bending = 1}, StressFreeAngle::flat);
  const auto& x = membrane.reference().vertices;
  for (const Edge& edge : membrane.edges()) {
    const auto at = [&](int v) { return Vec3{x(v, 0), x(v, 1), x(v, 2)}; };
    const Vec3 side = at(edge.v2) - at(edge.v1);
    const Vec3 n1 = cross(side, at(edge.v3) - at(edge.v1)), n2 = cross(at(edge.v4) - at(edge.v1), side);
    EXPECT_GT(bending_angle(side, n1, n2, {0, 1}), 0.01);
  }
}

/// sqrt(3) kB sum theta^2 of a sphere is 1.009 of the Helfrich energy 8 pi kB on 2000 faces, whatever its
/// size; the other laws are in bending_law_test.cpp.
TEST(Bending, SphereEnergy) {
  const double kb = 0.2;
  const MembraneModuli moduli{.bending = kb, .bending_law = BendingLaw::hinge_sphere};
  const Membrane membrane(sphere(10, radius), moduli, StressFreeAngle::flat);
  const double energy = membrane.energy(membrane.reference().vertices);
  EXPECT_NEAR(energy / (8 * std::numbers::pi * kb), 1.009, 1e-4);
  const Membrane larger(sphere(10, 5 * radius), moduli, StressFreeAngle::flat);
  EXPECT_NEAR(larger.energy(larger.reference().vertices) / energy, 1, 1e-12);
  EXPECT_NEAR(Membrane(sphere(10, radius), moduli).energy(membrane.reference().vertices), 0, 1e-20);
}

/// Uniform growth by a factor s: area s^2, volume s^3, every face alike.
TEST(Membrane, MeasuresUniformGrowth) {
  Membrane membrane(sphere(5, radius), {.global_area = 2, .volume = 3});
  const double s = 1.01, area0 = membrane.reference_area(), volume0 = membrane.reference_volume();
  const Eigen::MatrixX3d x = s * membrane.reference().vertices;
  const MembraneState state = membrane.measure(x);
  EXPECT_NEAR(state.area / area0, s * s, 1e-13);
  EXPECT_NEAR(state.volume / volume0, s * s * s, 1e-13);
  EXPECT_NEAR(state.min_face_ratio, s * s, 1e-12);
  EXPECT_NEAR(state.max_local_area_strain, s * s - 1, 1e-12);
  const MembraneEnergy energy = membrane.energy_terms(x);
  EXPECT_NEAR(energy.area, std::pow(s * s - 1, 2) * area0, 1e-12 * area0);
  EXPECT_NEAR(energy.volume, 1.5 * std::pow(s * s * s - 1, 2) * volume0, 1e-12 * volume0);
  EXPECT_EQ(energy.bending, 0);
}

/// Stretching along x alone, by a factor of 2: faces across x grow least, those along it most.
// Grown by 1 + g: area strain (1 + g)^2 - 1 everywhere, the tension of Skalak's law and of the whole area.
TEST(Membrane, FaceFieldsOfUniformGrowth) {
  const Membrane membrane(make_cell("red_blood_cell", 6, radius), all_terms);
  const double g = 1e-4, strain = (1 + g) * (1 + g) - 1;
  const FaceFields fields = membrane.face_fields(membrane.reference().vertices * (1 + g));
  const double modulus = 4 * all_terms.shear / 12 + 2 * all_terms.local_area / 3 + all_terms.global_area;
  for (Eigen::Index f = 0; f < membrane.face_count(); ++f) {
    EXPECT_NEAR(fields.area_strain(f), strain, 1e-10);
    EXPECT_NEAR(fields.mean_tension(f), modulus * strain, 1e-3 * modulus * strain);
    EXPECT_NEAR(fields.shear_tension(f), 0, 1e-6);
  }
}

TEST(Membrane, MeasuresTheExtremeFaces) {
  Membrane membrane(sphere(8, radius), {});
  Eigen::MatrixX3d x = membrane.reference().vertices;
  x.col(0) *= 2;
  const MembraneState state = membrane.measure(x);
  EXPECT_NEAR(state.min_face_ratio, 1, 0.05);
  EXPECT_NEAR(state.max_local_area_strain, 1, 0.05);
  x.col(0) /= 4;
  EXPECT_NEAR(membrane.measure(x).min_face_ratio, 0.5, 0.03);
  EXPECT_NEAR(membrane.measure(x).max_local_area_strain, 0.5, 0.03);
}

}  // namespace
}  // namespace dld
