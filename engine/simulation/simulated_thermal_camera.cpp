#include "engine/simulation/simulated_thermal_camera.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/picture_outline.h"
#include "engine/simulation/board_script.h"
#include "engine/simulation/rig_faces.h"
#include "engine/thermography/frame_picture_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

SimulatedThermalCameraConfig usable(SimulatedThermalCameraConfig config) {
    if (config.camera.width != config.profile.width || config.camera.height != config.profile.height ||
        !config.profile.frameRate_Hz)
        throw std::invalid_argument(
            "SimulatedThermalCamera: a camera of the profile's size and rate is needed");
    return config;
}

Error noPicture(const char* why) {
    return {MessageCode::CameraLost, "", {"simulated", why}};
}

} // namespace

std::string bytesOfFrame(const ThermalPicture& picture, const ThermalProfile& profile) {
    const auto rowBytes = static_cast<std::size_t>(profile.width) * 2;
    std::string bytes(static_cast<std::size_t>(profile.skipTop) * rowBytes, '\0');
    for (const unsigned number : countsOfPicture(picture, profile).counts) {
        const auto low = static_cast<char>(number & 0xffU), high = static_cast<char>(number >> 8U);
        bytes += profile.isBigEndian ? high : low;
        bytes += profile.isBigEndian ? low : high;
    }
    return bytes + std::string(static_cast<std::size_t>(profile.skipBottom) * rowBytes, '\0');
}

SimulatedThermalCamera::SimulatedThermalCamera(SimulatedThermalCameraConfig config)
    : m_config(usable(std::move(config))), m_band(bandOf(m_config.profile)),
      m_sensor(*m_band, m_config.errors, m_config.camera.width, m_config.camera.height,
               m_config.environment_K),
      m_painter(m_config.camera, room()) {
    const auto add = [&](const Shape& shape, int layer) {
        m_faces.push_back({ringsOf(shape), 0.0F, 0.0F, {}, 0.0F, layer});
    };
    for (std::size_t p = 0; p < m_config.source.size(); ++p)
        add(m_config.source[p].shape, static_cast<int>(p) - static_cast<int>(m_config.source.size()));
    for (const auto& object : m_config.objects)
        add(object.shape, 1);
    for (const auto& fixture : m_config.fixtures)
        add(fixture.shape, 1);
    for (const auto& shield : m_config.shields)
        add(shield.shape, 1);
}

double SimulatedThermalCamera::radianceOf(const FaceSurroundings& face, double T_K) const {
    return m_band->radiance(apparentTemperature(*m_band, face, T_K));
}

GreyCanvas SimulatedThermalCamera::room() const {
    const CameraModel& camera = m_config.camera;
    return {
        camera.width, camera.height,
        std::vector<float>(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height),
                           static_cast<float>(m_band->radiance(m_config.environment_K)))};
}

void SimulatedThermalCamera::observe(const ThermalMoment& moment) {
    if (moment.objects.size() != m_config.objects.size() || moment.source_K.size() != m_config.source.size())
        throw std::invalid_argument("SimulatedThermalCamera: one temperature each");
    const std::scoped_lock lock(m_mutex);
    while (!m_moments.empty() && m_moments.back().time_s >= moment.time_s) // a clock set back, too
        m_moments.pop_back();
    m_moments.push_back(moment);
    while (m_moments.size() > 1 && m_moments[1].time_s <= moment.time_s - m_config.delay_s)
        m_moments.pop_front();
}

void SimulatedThermalCamera::setBoard(std::optional<Board> board) {
    const std::scoped_lock lock(m_mutex);
    m_board.reset();
    if (board)
        m_board = ShownBoard{*board, m_moments.empty() ? 0.0 : m_moments.back().time_s};
}

void SimulatedThermalCamera::setUnplugged(bool unplugged) {
    const std::scoped_lock lock(m_mutex);
    m_isUnplugged = unplugged;
}

std::vector<PixelBox> SimulatedThermalCamera::parts(const ThermalMoment& moment) const {
    constexpr double kMargin_px = 4.0; // farther than blur carries, and than edges are read
    const CameraModel& camera = m_config.camera;
    const Pose X_CE = m_config.X_RC.inverse() * moment.X_RE;
    std::vector<PixelBox> out;
    for (const auto& object : m_config.objects) {
        const auto outline = outlineInPicture(camera, X_CE * object.X_EO, object.shape);
        if (outline.empty())
            continue;
        Eigen::AlignedBox2d box;
        for (const Eigen::Vector2d& p : outline)
            box.extend(p);
        const auto within = [](double value, int size) {
            return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
        };
        out.push_back({within(box.min().x() - kMargin_px, camera.width),
                       within(box.min().y() - kMargin_px, camera.height),
                       within(box.max().x() + kMargin_px, camera.width),
                       within(box.max().y() + kMargin_px, camera.height)});
    }
    return out;
}

const GreyCanvas& SimulatedThermalCamera::painted(const ThermalMoment& moment,
                                                  const std::optional<ShownBoard>& shown) {
    const Pose X_CR = m_config.X_RC.inverse();
    const double room = m_band->radiance(m_config.environment_K);
    std::vector<PlacedFace> placed;
    const auto place = [&](const Pose& X_RP, double front, double behind) {
        SceneFace& face = m_faces[placed.size()];
        face.front = static_cast<float>(front);
        face.behind = static_cast<float>(behind);
        placed.push_back({&face, X_CR * X_RP});
    };
    for (std::size_t p = 0; p < m_config.source.size(); ++p) {
        const auto& plate = m_config.source[p];
        const double front =
            plate.emittance * m_band->radiance(moment.source_K[p]) + (1.0 - plate.emittance) * room;
        place(moment.X_RS * plate.X_SP, front, room);
    }
    for (std::size_t i = 0; i < m_config.objects.size(); ++i) {
        // A scene's face has its front towards +z, an object its heated face towards -z.
        const ThermalMoment::Object& object = moment.objects[i];
        place(moment.X_RE * m_config.objects[i].X_EO, radianceOf(object.back, object.T_K),
              radianceOf(object.front, object.T_K));
    }
    for (const auto& fixture : m_config.fixtures)
        place(moment.X_RE * fixture.X_EO, room, room);
    for (const auto& shield : m_config.shields)
        place(shield.X_RB, room, room);
    SceneFace sheet;
    std::vector<PlacedFace> onTop;
    if (shown) {
        constexpr double kSheet = 0.95, kFoil = 0.3; // emittance
        const double warm = m_band->radiance(m_config.environment_K + 10.0);
        sheet = boardFace(shown->board);
        sheet.front = sheet.behind = static_cast<float>(kSheet * warm + (1.0 - kSheet) * room);
        sheet.markGrey = static_cast<float>(kFoil * warm + (1.0 - kFoil) * room);
        onTop.push_back({&sheet, boardPoseAt(shown->board, m_config.camera, moment.time_s - shown->since_s) *
                                     Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX())});
    }
    return m_painter.paint(placed, onTop);
}

Result<std::shared_ptr<const ThermalCameraFrame>> SimulatedThermalCamera::newest() {
    ThermalMoment seen;
    std::optional<ShownBoard> board;
    {
        const std::scoped_lock lock(m_mutex);
        if (m_isUnplugged)
            return noPicture("unplugged");
        if (m_moments.empty())
            return noPicture("not started");
        seen = m_moments.front();
        board = m_board;
    }
    const double time_s = seen.time_s, period_s = 1.0 / *m_config.profile.frameRate_Hz;
    const double passed_s = m_frame ? time_s - m_frame->time_s : period_s;
    if (passed_s >= 0.0 && passed_s < period_s - 1e-6)
        return m_frame;
    if (m_frame && m_sensor.isShut(time_s))
        return m_frame;
    const std::uint64_t number = m_frame ? m_frame->number + 1 : 1;
    const std::vector<PixelBox> all{{0, 0, m_config.camera.width, m_config.camera.height}};
    const ThermalPicture picture =
        m_sensor.caught(painted(seen, board), time_s, number, m_config.showsObjectsOnly ? parts(seen) : all);
    auto decoded = frameOfBytes(bytesOfFrame(picture, m_config.profile), m_config.profile, "simulated");
    if (!decoded)
        return decoded.error();
    m_frame = std::make_shared<ThermalCameraFrame>(
        ThermalCameraFrame{time_s, number, std::move(*decoded), m_sensor.opened_s(time_s)});
    return m_frame;
}

} // namespace bask
