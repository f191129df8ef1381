#include "engine/rig/camera_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/calibration/picture_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr double kCold_K = 5.0;       // above the room: a source that warms nothing noticeably
constexpr double kAsCold_K = 10.0;    // how far a camera that is not yet zeroed may be off
constexpr double kTogether_K = 2.0;   // how far cold objects may look different from one another
constexpr double kKnown_K = 0.1;      // how well the objects' temperature is known when they are cold
constexpr double kCooled_s = 600.0;   // since the source was not cold last: objects that were warm are cold
constexpr double kBoardGone_s = 10.0; // after it is looked for no more: a person takes it away
constexpr int kZeroFrames = 20;       // over which a zero is the mean
constexpr double kKept_s = 5.0;       // of moments, longer than any frame is under way
constexpr double kShutterPeriod_s = 180.0; // usual: it closed that long ago, where it is not told
constexpr double kLately_s = 10.0;         // of what the camera told of a neighbour
constexpr double kRoom_K = 0.3, kSource_K = 1.0, kSensor_K = 0.5; // standard uncertainties
constexpr double kUnknown_K = 20.0; // above the room: how warm a neighbour may be that nothing tells of

} // namespace

CameraThermometer::CameraThermometer(CameraThermometerSetup setup, ThermalCamera& camera, Robot& robot,
                                     HeatSource& source, const Clock& clock)
    : m_setup(std::move(setup)), m_camera(camera), m_robot(robot), m_source(source), m_rays(m_setup.camera),
      m_clock(clock), m_band(bandOf(camera.profile())), m_reflections(m_setup.reflecting, m_band),
      m_told(m_setup.objects.size()), m_zeros(m_setup.objects.size()), m_zeroFrames(m_setup.objects.size()),
      m_seen(m_setup.objects.size()) {
    if (!m_setup.isSourceTracked)
        m_X_RS = m_setup.geometry->X_RS();
}

std::optional<KnownTemperature> CameraThermometer::seenSource() const {
    if (m_setup.hasShutter && !m_source.heating())
        return KnownTemperature{m_setup.environment_K, kRoom_K};
    const auto reading = m_source.read();
    const bool isKnown =
        reading && reading->valid && reading->value_K > kMinBand_K && reading->value_K < kMaxBand_K;
    if (!isKnown)
        return std::nullopt;
    const double told_K = reading->standardUncertainty_K;
    return KnownTemperature{reading->value_K, told_K > 0.0 ? told_K : kSource_K};
}

// The camera first: a sensor that came off its object must not make its neighbours doubtful.
KnownTemperature CameraThermometer::temperatureOf(std::size_t object) const {
    if (const auto& told = m_told[object]; told && m_frame->time_s - told->time_s < kLately_s)
        return told->known;
    if (object < m_sensors.size() && m_sensors[object].valid && m_sensors[object].value_K > kMinBand_K &&
        m_sensors[object].value_K < kMaxBand_K) {
        const double told_K = m_sensors[object].standardUncertainty_K;
        return {m_sensors[object].value_K, told_K > 0.0 ? told_K : kSensor_K};
    }
    if (isCold())
        return {m_setup.environment_K, kRoom_K};
    return {m_setup.environment_K + 0.5 * kUnknown_K, standardOfLimits(0.5 * kUnknown_K)};
}

bool CameraThermometer::isCold() const {
    return m_isSourceCold && m_clock.now_s() - m_hot_s > kCooled_s;
}

void CameraThermometer::setRoom(double environment_K) {
    if (std::abs(environment_K - m_setup.environment_K) > kKnown_K)
        m_zeroFrames.assign(m_zeroFrames.size(), 0); // those were zeros to another room
    m_setup.environment_K = environment_K;
}

void CameraThermometer::noteMoment() {
    const std::optional<KnownTemperature> source = seenSource();
    m_isSourceCold = source && source->T_K < m_setup.environment_K + kCold_K;
    if (source && !m_isSourceCold)
        m_hot_s = m_clock.now_s();
    const auto state = m_robot.state();
    if (!state) {
        if (!m_moments.empty())
            m_moments.back().isPlaceSure = false;
        return;
    }
    const bool isPossible =
        m_setup.geometry->lowestPoint_m(state->coordinates) > -m_setup.geometry->floor_m();
    if (!m_moments.empty() && state->time_s <= m_moments.back().time_s)
        m_moments.pop_back();
    m_moments.push_back(
        {state->time_s, state->coordinates, state->isPlaceSure && isPossible, source, m_X_RS});
    while (m_moments.size() > 2 && m_moments[1].time_s < state->time_s - kKept_s)
        m_moments.pop_front();
}

Vector6d CameraThermometer::placeAt(double time_s) const {
    for (std::size_t k = m_moments.size(); k-- > 1;) {
        const Moment &a = m_moments[k - 1], &b = m_moments[k];
        if (time_s >= a.time_s)
            return a.q + std::clamp((time_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0) * (b.q - a.q);
    }
    return m_moments.front().q;
}

std::optional<Pose> CameraThermometer::sourceAt(double time_s) const {
    for (std::size_t k = m_moments.size(); k-- > 1;) {
        const Moment &a = m_moments[k - 1], &b = m_moments[k];
        if (time_s < a.time_s)
            continue;
        if (!a.X_RS || !b.X_RS)
            break;
        const double share = std::clamp((time_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0);
        Pose X_RS(Eigen::Quaterniond(a.X_RS->linear()).slerp(share, Eigen::Quaterniond(b.X_RS->linear())));
        X_RS.translation() = a.X_RS->translation() + share * (b.X_RS->translation() - a.X_RS->translation());
        return X_RS;
    }
    return nearest(time_s).X_RS;
}

const CameraThermometer::Moment& CameraThermometer::nearest(double time_s) const {
    return *std::ranges::min_element(m_moments, {},
                                     [&](const Moment& moment) { return std::abs(moment.time_s - time_s); });
}

std::vector<ReadObject> CameraThermometer::objectsAt(const Vector6d& q, const Moment& then) {
    const std::size_t N = m_setup.objects.size();
    const KnownTemperature room{m_setup.environment_K, kRoom_K};
    ReflectionMoment moment{poseFromCoordinates(q),
                            then.X_RS.value_or(m_setup.geometry->X_RS()),
                            then.source.value_or(room),
                            room,
                            {}};
    std::vector<Pose> poses;
    std::vector<bool> wanted(2 * N);
    for (std::size_t i = 0; i < N; ++i) {
        moment.objects.push_back(temperatureOf(i));
        poses.push_back(moment.X_RE * poseFromCoordinates(m_setup.objects[i].mounting));
        const bool isFront = (poses[i].inverse() * m_setup.X_RC->translation()).z() < 0.0;
        wanted[isFront ? i : N + i] = true;
    }
    std::vector<KnownFace> faces = m_reflections.at(moment, wanted);
    std::vector<ReadObject> out;
    for (std::size_t i = 0; i < N; ++i)
        out.push_back({{m_setup.objects[i].shape, poses[i]}, std::move(faces[i]), std::move(faces[N + i])});
    return out;
}

std::vector<PlacedPlate> CameraThermometer::screensAt(const Vector6d& q, const Moment& then) const {
    const Pose X_RE = poseFromCoordinates(q);
    std::vector<PlacedPlate> out{{m_setup.source, then.X_RS.value_or(m_setup.geometry->X_RS())}};
    for (const PlateSpec& fixture : m_setup.fixtures)
        out.push_back({fixture.shape, X_RE * poseFromCoordinates(fixture.pose)});
    for (const PlateSpec& shield : m_setup.shields)
        out.push_back({shield.shape, poseFromCoordinates(shield.pose)});
    return out;
}

double CameraThermometer::sinceShutter_s() const {
    const auto& shutter_s = m_frame->shutter_s;
    return shutter_s ? std::max(m_frame->time_s - *shutter_s, 0.0) : kShutterPeriod_s;
}

Result<std::vector<Reading>> CameraThermometer::read() {
    noteMoment();
    const auto newest = m_camera.newest();
    if (!newest) {
        invalidate(newest.error().message);
        return newest.error();
    }
    const double age_s = m_clock.now_s() - (*newest)->time_s;
    if (!m_frame || m_frame->number != (*newest)->number) {
        m_frame = *newest;
        readFrame();
    } else if (age_s > kOldFrame_s) {
        invalidate({MessageCode::ThermalFrameOld, {formatNumber(age_s, 2)}});
    }
    std::vector<Reading> out;
    for (const Seen& seen : m_seen)
        out.push_back(seen.reading);
    return out;
}

/// Nothing of an earlier frame is told as if it were of now.
void CameraThermometer::invalidate(const Message& reason) {
    m_view.reset();
    for (Seen& seen : m_seen) {
        seen = {};
        seen.reading = Reading{m_clock.now_s(), 0.0, false, SensorFault::Other, 0.0, reason};
    }
}

void CameraThermometer::readFrame() {
    if (!m_setup.X_RC)
        return invalidate({MessageCode::ThermalPoseUnknown, {}});
    if (m_moments.empty() || !nearest(m_frame->time_s).isPlaceSure)
        return invalidate({MessageCode::ThermalPlaceUnsure, {}});
    if (m_isBoardShown || m_frame->time_s < m_board_s + kBoardGone_s)
        return invalidate({MessageCode::ThermalFaceHidden, {"0", std::to_string(rigPixels().minPixels)}});
    Moment then = nearest(m_frame->time_s);
    if (m_setup.isSourceTracked)
        then.X_RS = sourceAt(m_frame->time_s);
    const Vector6d q = placeAt(m_frame->time_s);
    const std::vector<PlacedPlate> screens = screensAt(q, then);
    const int passes = m_reflections.exchange() ? 2 : 1;
    for (int pass = 0; pass < passes; ++pass) {
        invalidate({});
        const std::vector<ReadObject> objects = objectsAt(q, then);
        const auto readAll = [&] {
            return readObjects(*m_band, m_frame->frame.picture, m_rays, *m_setup.X_RC, objects, screens,
                               m_zeros, m_camera.profile().uncertainty, sinceShutter_s(),
                               rigPixels(m_setup.sight));
        };
        auto read = readAll();
        if (pass == 0 && findZeros(objects, read))
            read = readAll();
        for (std::size_t i = 0; i < read.size(); ++i)
            take(i, then, objects[i], std::move(read[i]));
    }
}

void CameraThermometer::setBoardShown(bool isShown) {
    if (m_isBoardShown && !isShown)
        m_board_s = m_clock.now_s();
    m_isBoardShown = isShown;
}

bool CameraThermometer::findZeros(const std::vector<ReadObject>& objects,
                                  const std::vector<Result<ObjectReading>>& read) {
    std::vector<double> apparent_K;
    for (const auto& reading : read)
        if (reading)
            apparent_K.push_back(reading->region.mean_K);
    if (!isCold() || apparent_K.empty())
        return false;
    const auto middle = apparent_K.begin() + static_cast<std::ptrdiff_t>(apparent_K.size() / 2);
    std::ranges::nth_element(apparent_K, middle);
    bool isFound = false;
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (!read[i])
            continue;
        const RegionStatistics& region = read[i]->region;
        if (std::abs(region.mean_K - m_setup.environment_K) > kAsCold_K ||
            std::abs(region.mean_K - *middle) > kTogether_K)
            continue;
        const KnownFace& face = read[i]->seen.isFront ? objects[i].front : objects[i].back;
        CameraZero zero = zeroAt(*m_band, face.surroundings, m_setup.environment_K, kKnown_K, region.mean_K,
                                 region.standardError_K);
        m_zeroFrames[i] = std::min(m_zeroFrames[i] + 1, kZeroFrames);
        if (m_zeros[i]) {
            zero.offset_K = m_zeros[i]->offset_K + (zero.offset_K - m_zeros[i]->offset_K) / m_zeroFrames[i];
            zero.apparent_K = m_setup.environment_K + zero.offset_K;
        }
        m_zeros[i] = zero;
        isFound = true;
    }
    return isFound;
}

void CameraThermometer::take(std::size_t object, const Moment& then, const ReadObject& known,
                             Result<ObjectReading> reading) {
    Seen& seen = m_seen[object];
    if (!reading) {
        seen.reading.reason = reading.error().message;
        return;
    }
    seen.pixels = std::move(reading->seen.pixels);
    seen.isPartlyOutside = !reading->seen.isWhole;
    const RegionStatistics& region = reading->region;
    const auto& warnAbove_K = m_camera.profile().warnAbove_K;
    const KnownFace& face = reading->seen.isFront ? known.front : known.back;
    const bool isReflecting =
        m_reflections.seesSource(reading->seen.isFront ? object : m_setup.objects.size() + object);
    if (!m_zeros[object])
        seen.reading.reason = {MessageCode::ThermalNotZeroed, {}};
    else if (isReflecting && !then.X_RS)
        seen.reading.reason = {MessageCode::ThermalSourceUneven, {}};
    else if (isReflecting && !then.source)
        seen.reading.reason = {MessageCode::ThermalSourceUnknown, {}};
    else if (warnAbove_K && region.max_K > *warnAbove_K)
        seen.reading.reason = {MessageCode::ThermalAboveRange, {temperatureArg(*warnAbove_K)}};
    if (seen.reading.reason.code != MessageCode::None)
        return;
    const FaceReading& told = reading->face;
    m_told[object] = Told{m_frame->time_s, {told.T_K, told.standardUncertainty_K}};
    seen.reading = Reading{m_frame->time_s, told.T_K, true, SensorFault::None, told.standardUncertainty_K};
    seen.sample = {told.T_K, told.standardUncertainty_K,
                   region.difference ? region.difference->value_K : std::numeric_limits<double>::quiet_NaN(),
                   static_cast<double>(region.pixels), seen.isPartlyOutside};
    seen.face = face.surroundings;
    seen.apparent_K = region.mean_K - m_zeros[object]->offset_K;
}

double CameraThermometer::explainingEmittance(std::size_t object, double T_K) const {
    const Seen& seen = m_seen.at(object);
    return seen.reading.valid && T_K > kMinBand_K && T_K < kMaxBand_K
               ? bask::explainingEmittance(*m_band, seen.face, seen.apparent_K, T_K)
               : std::numeric_limits<double>::quiet_NaN();
}

double CameraThermometer::reflected_K(std::size_t object) const {
    const Seen& seen = m_seen.at(object);
    return seen.reading.valid ? reflectedTemperature(*m_band, seen.face)
                              : std::numeric_limits<double>::quiet_NaN();
}

TraceFrame CameraThermometer::frame() const {
    if (!m_frame)
        return {};
    return {m_frame->time_s, {m_frame, &m_frame->frame.picture}};
}

std::shared_ptr<const ThermalView> CameraThermometer::view() {
    const auto read = this->read();
    if (m_frame && !m_view)
        m_view = viewOfFrame();
    auto view = std::make_shared<ThermalView>(m_view.value_or(ThermalView{}));
    view->cameraName = cameraName(m_camera.profile());
    view->leftOut = m_camera.leftOut();
    view->age_s = m_frame ? m_clock.now_s() - m_frame->time_s : 0.0;
    if (!read)
        view->problem = read.error().message;
    return view;
}

ThermalView CameraThermometer::viewOfFrame() const {
    ThermalView view;
    view.picture = frame().picture;
    view.time_s = m_frame->time_s;
    if (m_frame->shutter_s)
        view.sinceShutter_s = sinceShutter_s();
    view.drift_K = m_camera.profile().uncertainty.drift_K_min * sinceShutter_s() / 60.0;
    for (std::size_t i = 0; i < m_seen.size(); ++i) {
        const Seen& seen = m_seen[i];
        ThermalObjectView object;
        if (m_setup.X_RC && !m_moments.empty()) {
            const Pose X_CE = m_setup.X_RC->inverse() * poseFromCoordinates(placeAt(m_frame->time_s));
            object.outline_px =
                outlineInPicture(m_setup.camera, X_CE * poseFromCoordinates(m_setup.objects[i].mounting),
                                 m_setup.objects[i].shape);
        }
        object.pixels = seen.pixels;
        object.isPartlyOutside = seen.isPartlyOutside;
        if (seen.reading.valid)
            object.T_K = seen.reading.value_K;
        object.uncertainty_K = seen.reading.standardUncertainty_K;
        object.spread_K = seen.sample.spread_K;
        object.reason = seen.reading.reason;
        view.objects.push_back(std::move(object));
    }
    return view;
}

CameraThermometer::Memory CameraThermometer::memory() const {
    Memory out{m_setup.camera, m_setup.X_RC, {}, m_hot_s, m_isBoardShown ? m_clock.now_s() : m_board_s};
    for (std::size_t i = 0; i < m_zeros.size(); ++i)
        if (m_zeros[i])
            out.zeros[m_setup.objects[i].name] = *m_zeros[i];
    return out;
}

void CameraThermometer::use(const Memory& before) {
    m_hot_s = before.hot_s;
    m_board_s = before.board_s;
    const bool isSamePlace = before.X_RC.has_value() == m_setup.X_RC.has_value() &&
                             (!m_setup.X_RC || before.X_RC->matrix() == m_setup.X_RC->matrix());
    if (!isSamePlace || before.camera != m_setup.camera) {
        m_hot_s = m_clock.now_s();
        return;
    }
    for (std::size_t i = 0; i < m_zeros.size(); ++i)
        if (const auto zero = before.zeros.find(m_setup.objects[i].name); zero != before.zeros.end()) {
            m_zeros[i] = zero->second;
            m_zeroFrames[i] = kZeroFrames;
        }
}

} // namespace bask
