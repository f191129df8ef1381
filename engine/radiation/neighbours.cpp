#include "engine/radiation/neighbours.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"
#include "engine/radiation/plate_crossing.h"
#include "engine/radiation/shade.h"

#include <Eigen/LU>

#include <numbers>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kTolerance = 1e-5; ///< of the view factors between the faces

/// A face of a plate, which radiates along -z of its frame.
struct PlateFace {
    std::size_t plate = 0;
    bool isBack = false;
    Pose X_E = Pose::Identity();
};

/// The fronts of all plates, then their backs.
std::vector<PlateFace> facesOf(const MountedObjects& objects) {
    const Pose turned(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    std::vector<PlateFace> faces;
    for (std::size_t i = 0; i < objects.size(); ++i)
        faces.push_back({i, false, objects[i].X_EO});
    for (std::size_t i = 0; i < objects.size(); ++i)
        faces.push_back({i, true, objects[i].X_EO * turned});
    return faces;
}

const RadiatingContour& contourOf(const MountedObjects& objects, const PlateFace& face) {
    const RadiatingContour& front = objects[face.plate].contour;
    return face.isBack ? front.impl().plate().back() : front;
}

std::vector<Blocker> othersThan(const MountedObjects& objects, std::size_t a, std::size_t b,
                                const Pose& X_SE) {
    std::vector<Blocker> others;
    for (std::size_t k = 0; k < objects.size(); ++k)
        if (k != a && k != b)
            others.push_back({objects[k].contour, X_SE * objects[k].X_EO});
    for (const MountedContour& fixture : objects.screens().fixtures)
        others.push_back({fixture.contour, X_SE * fixture.X_EO});
    return others;
}

/// Whether two faces see each other, but for what stands between them.
bool faceEachOther(const MountedObjects& objects, const PlateFace& a, const PlateFace& b) {
    const MountedContour& plateA = objects[a.plate];
    const MountedContour& plateB = objects[b.plate];
    return a.plate != b.plate && isInFront(plateB.contour, plateB.X_EO, a.X_E) &&
           isInFront(plateA.contour, plateA.X_EO, b.X_E) &&
           !platesCross(plateA.contour, plateA.X_EO, plateB.contour, plateB.X_EO);
}

} // namespace

Eigen::MatrixXd faceViewFactors(const MountedObjects& objects) {
    const std::vector<PlateFace> faces = facesOf(objects);
    const auto count = static_cast<Eigen::Index>(faces.size());
    Eigen::MatrixXd F = Eigen::MatrixXd::Zero(count, count);
    ShadeOptions options;
    options.unshaded.tolerance = kTolerance;
    options.tolerance = kTolerance;
    options.refusesCrossing = false;
    for (std::size_t a = 0; a < faces.size(); ++a)
        for (std::size_t b = a + 1; b < faces.size(); ++b) {
            if (!faceEachOther(objects, faces[a], faces[b]))
                continue;
            // A source radiates along +z: it is the plate's other face turned over.
            const PlateFace& source = faces[(b + objects.size()) % faces.size()];
            const Pose X_SE = source.X_E.inverse();
            const RadiatingContour& from = contourOf(objects, faces[a]);
            const RadiatingContour& to = contourOf(objects, source);
            const std::vector<Blocker> others = othersThan(objects, faces[a].plate, faces[b].plate, X_SE);
            const double value = shadedViewFactor(to, from, X_SE * faces[a].X_E, others, options).value;
            const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
            F(i, j) = value;
            F(j, i) = value * from.area_m2() / to.area_m2();
        }
    return F.isZero(0.0) ? Eigen::MatrixXd() : F;
}

Neighbours::Neighbours(const MountedObjects& objects, const std::vector<FaceMaterial>& fronts) {
    if (fronts.size() != objects.size())
        throw std::invalid_argument("Neighbours: one material an object");
    if (!objects.mayShade()) // no front sees anything of another plate
        return;
    const Eigen::MatrixXd F = faceViewFactors(objects);
    if (F.size() == 0)
        return;
    const auto N = static_cast<Eigen::Index>(objects.size());
    Eigen::VectorXd emittance(N);
    Eigen::VectorXd ofSource = Eigen::VectorXd::Ones(2 * N), ofObjects = ofSource; // reflectances
    for (Eigen::Index i = 0; i < N; ++i) {
        const FaceMaterial& front = fronts[static_cast<std::size_t>(i)];
        emittance[i] = front.emittance;
        ofSource[i] = 1.0 - front.absorptance;
        ofObjects[i] = 1.0 - front.emittance;
    }
    // Irradiation G = F B + direct, radiosity B = reflectance G + emitted.
    const auto solved = [&](const Eigen::VectorXd& reflectances, const Eigen::MatrixXd& direct) {
        const Eigen::MatrixXd A =
            Eigen::MatrixXd::Identity(2 * N, 2 * N) - F * reflectances.asDiagonal().toDenseMatrix();
        return Eigen::MatrixXd(A.partialPivLu().solve(direct).topRows(N));
    };
    m_reflected = solved(ofSource, Eigen::MatrixXd::Identity(2 * N, N));
    m_received = solved(ofObjects, F.leftCols(N) * emittance.asDiagonal());
}

Eigen::MatrixXd Neighbours::withReflections(const Eigen::MatrixXd& F) const {
    return exchange() ? Eigen::MatrixXd(m_reflected * F) : F;
}

Eigen::VectorXd Neighbours::gains_K4(const Eigen::VectorXd& excess_K4) const {
    return exchange() ? Eigen::VectorXd(m_received * excess_K4) : Eigen::VectorXd::Zero(excess_K4.size());
}

} // namespace bask
