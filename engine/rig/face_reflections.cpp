#include "engine/rig/face_reflections.h"

#include "engine/radiation/neighbours.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kSourceTolerance = 1e-6; // of a view factor
// Standard uncertainties of view factors: of the source's by its pose and the robot's, of a neighbour's by
// half a millimetre of its mounting at a distance of a centimetre.
constexpr double kSourceView = 0.005, kNeighbourView = 0.05;
constexpr double kMinView = 1e-6;  // of a neighbour that counts
constexpr int kBounces = 30;       // between objects; each is weaker by the view factor times the reflectance
constexpr double kMinGlow = 1e-12; // radiance above the room's, of a source that is seen

} // namespace

FaceReflections::FaceReflections(ReflectingRig rig, std::shared_ptr<const BandRadiance> band)
    : m_rig(std::move(rig)), m_band(std::move(band)), m_backs(m_rig.objects.turnedOver(Pose::Identity())),
      m_F(faceViewFactors(m_rig.objects)) {
    const std::size_t N = m_rig.objects.size();
    if (m_rig.emittances.size() != N || m_rig.emittanceUncertainties.size() != N)
        throw std::invalid_argument("FaceReflections: one emittance with its uncertainty an object");
    if (m_rig.sourceTerms.empty() || m_rig.emission.terms.size() != m_rig.sourceTerms.size())
        throw std::invalid_argument("FaceReflections: one emission a term of the source");
}

// In the band each part is brighter than the room by eps (L(T) - L(T_env)), and at the edge of a ring that
// falls by the rise of the temperature times eps L'(T).
std::vector<double> FaceReflections::brightness(double source_K) const {
    const double room_K = m_rig.emission.environment_K, excess_K = source_K - room_K;
    const double room = m_band->radiance(room_K);
    std::vector<double> out;
    for (const EmissionTerm& term : m_rig.emission.terms) {
        const double part_K = term.temperature.at_K(source_K, room_K);
        const double asked_K = room_K + term.temperature.ratio * excess_K + term.temperature.offset_K;
        const bool isBounded = std::abs(asked_K - part_K) > 1e-9; // there the temperature does not rise
        const double rise_K =
            term.rise && !isBounded ? term.rise->ratio * excess_K + term.rise->offset_K : 0.0;
        out.push_back(term.rise ? -rise_K * term.emittance * m_band->derivative(part_K)
                                : term.emittance * (m_band->radiance(part_K) - room));
    }
    return out;
}

FaceReflections::Glow FaceReflections::glowAt(const ReflectionMoment& moment) {
    m_rig.emission.environment_K = moment.room.T_K;
    const double source_K = moment.source.T_K;
    const auto& terms = m_rig.emission.terms;
    const bool isEven = terms.size() == 1 && terms.front().temperature == PartTemperature{};
    Glow glow{RadiatingSource(m_rig.sourceTerms, std::vector(terms.size(), 1.0)), {}, {}};
    if (isEven) {
        glow.surface = {0.0, source_K, terms.front().emittance};
        return glow;
    }
    glow.surface.emittance = 0.0;
    for (const EmissionTerm& term : terms) {
        glow.surface.T_K = std::max(glow.surface.T_K, term.temperature.at_K(source_K, moment.room.T_K));
        glow.surface.emittance = std::max(glow.surface.emittance, term.emittance);
    }
    for (const PartTemperature& point : m_rig.emission.profile)
        glow.surface.T_K = std::max(glow.surface.T_K, point.at_K(source_K, moment.room.T_K));
    const double unit =
        glow.surface.emittance * (m_band->radiance(glow.surface.T_K) - m_band->radiance(moment.room.T_K));
    glow.isSeen = unit > kMinGlow;
    if (!glow.isSeen)
        return glow;
    const auto factors = [&](double at_K) {
        std::vector<double> out = brightness(at_K);
        for (double& factor : out)
            factor /= unit;
        return out;
    };
    glow.source = glow.source.withFactors(factors(source_K));
    glow.hotter = glow.source.withFactors(factors(source_K + 1.0));
    return glow;
}

void FaceReflections::addSource(const Glow& glow, std::size_t face, const Pose& X_SE,
                                const KnownTemperature& source, KnownFace& out) const {
    const std::size_t N = m_rig.objects.size();
    const bool isFront = face < N;
    const MountedObjects& objects = isFront ? m_rig.objects : m_backs;
    const auto seen = [&](const RadiatingSource& of) {
        return objects.viewFactorValue(of, face % N, X_SE, kSourceTolerance);
    };
    ReflectedSurface surface = glow.surface;
    surface.viewFactor = glow.isSeen ? std::clamp(seen(glow.source), 0.0, 1.0) : 0.0;
    if (!isFront && surface.viewFactor <= 0.0)
        return;
    double T_K = source.uncertainty_K;
    if (glow.hotter && surface.viewFactor > 0.0) {
        const double unit =
            surface.emittance * (m_band->radiance(surface.T_K) - m_band->radiance(out.surroundings.T_env_K));
        const double slope = (seen(*glow.hotter) - surface.viewFactor) * unit; // per K
        T_K *= std::abs(slope) / (surface.viewFactor * surface.emittance * m_band->derivative(surface.T_K));
    }
    out.surroundings.surfaces.push_back(surface);
    out.surfaces.push_back({kSourceView, T_K, m_rig.sourceEmittanceUncertainty});
}

// What falls on a face beyond the room's radiance, g = s + F b, and what leaves it, b = eps e + (1 - eps) g,
// with e of its temperature and s of the source.
void FaceReflections::addNeighbours(const ReflectionMoment& moment, std::vector<KnownFace>& faces) const {
    const std::size_t N = m_rig.objects.size();
    const auto count = static_cast<Eigen::Index>(faces.size());
    const double room = m_band->radiance(moment.room.T_K);
    Eigen::VectorXd emittance(count), own(count), ofSource = Eigen::VectorXd::Zero(count);
    for (Eigen::Index f = 0; f < count; ++f) {
        const KnownFace& face = faces[static_cast<std::size_t>(f)];
        emittance[f] = face.surroundings.emittance;
        own[f] = m_band->radiance(moment.objects[static_cast<std::size_t>(f) % N].T_K) - room;
        for (const ReflectedSurface& surface : face.surroundings.surfaces)
            ofSource[f] += surface.viewFactor * surface.emittance * (m_band->radiance(surface.T_K) - room);
    }
    const Eigen::VectorXd emitted = emittance.cwiseProduct(own);
    Eigen::VectorXd received = ofSource, leaving;
    for (int k = 0; k < kBounces; ++k) {
        leaving = emitted + received - emittance.cwiseProduct(received);
        received = ofSource + m_F * leaving;
    }
    for (Eigen::Index f = 0; f < count; ++f) {
        KnownFace& face = faces[static_cast<std::size_t>(f)];
        const bool hasSource = m_seesSource[static_cast<std::size_t>(f)];
        const double share = 1.0 / std::max(m_F.row(f).sum(), 1.0); // view factors are rounded
        double left = 1.0;                                          // of the view, for the source
        for (Eigen::Index k = 0; k < count; ++k) {
            const double F = share * m_F(f, k);
            const double T_K = m_band->temperature(room + leaving[k]);
            if (F < kMinView || !std::isfinite(T_K))
                continue;
            const std::size_t object = static_cast<std::size_t>(k) % N;
            const KnownTemperature& known = moment.objects[object];
            const double byOwn = emittance[k] * m_band->derivative(known.T_K) * known.uncertainty_K;
            const double byEmittance = (own[k] - received[k]) * m_rig.emittanceUncertainties[object];
            left -= F;
            face.surroundings.surfaces.push_back({F, T_K, 1.0});
            face.surfaces.push_back({std::min(kSourceView, kNeighbourView * F),
                                     std::hypot(byOwn, byEmittance) / m_band->derivative(T_K), 0.0});
        }
        if (hasSource) {
            double& ofSourceNow = face.surroundings.surfaces.front().viewFactor;
            ofSourceNow = std::min(ofSourceNow, std::max(left, 0.0));
        }
    }
}

std::vector<KnownFace> FaceReflections::at(const ReflectionMoment& moment, const std::vector<bool>& wanted) {
    const std::size_t N = m_rig.objects.size();
    if (moment.objects.size() != N || wanted.size() != 2 * N)
        throw std::invalid_argument("FaceReflections: one temperature an object, and two faces");
    m_rig.objects.setSourceAt(moment.X_RS);
    m_backs.setSourceAt(moment.X_RS);
    const Glow glow = glowAt(moment);
    const Pose X_SE = moment.X_RS.inverse() * moment.X_RE;
    std::vector<KnownFace> faces(2 * N);
    m_seesSource.assign(2 * N, false);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        KnownFace& face = faces[f];
        face.surroundings = {m_rig.emittances[f % N], {}, moment.room.T_K};
        face.emittanceUncertainty = m_rig.emittanceUncertainties[f % N];
        face.roomUncertainty_K = moment.room.uncertainty_K;
        if (wanted[f] || exchange())
            addSource(glow, f, X_SE, moment.source, face);
        m_seesSource[f] = !face.surroundings.surfaces.empty();
    }
    if (exchange())
        addNeighbours(moment, faces);
    return faces;
}

} // namespace bask
