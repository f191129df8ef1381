#include "widgets/scene/camera_fit.h"

#include <QRectF>

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

const Box kBox(Eigen::Vector3d(-0.2, -0.2, 0.0), Eigen::Vector3d(0.2, 0.2, 0.3));

class CameraFit : public ::testing::TestWithParam<ViewPreset> {};

// Catches a box that is cut off, lies under the axes' numbers, or is left small, at any shape of the view.
TEST_P(CameraFit, TheBoxFillsTheRoomBetweenTheMargins) {
    const QMarginsF margins(60.0, 24.0, 100.0, 50.0);
    for (const QSizeF size : {QSizeF(1000, 700), QSizeF(400, 900), QSizeF(1400, 300)}) {
        vtkNew<vtkCamera> camera;
        applyPreset(*camera, GetParam());
        fitCamera(*camera, kBox, size, margins);
        const Projection projection(*camera, size);
        QRectF seen;
        for (int i = 0; i < 8; ++i) {
            const QPointF p = projection(kBox.corner(static_cast<Box::CornerType>(i)));
            seen = i == 0 ? QRectF(p, QSizeF(1e-9, 1e-9)) : seen.united(QRectF(p, QSizeF(1e-9, 1e-9)));
        }
        const QRectF room = QRectF(QPointF(0, 0), size).marginsRemoved(margins);
        EXPECT_TRUE(room.adjusted(-0.5, -0.5, 0.5, 0.5).contains(seen));
        EXPECT_NEAR(std::max(seen.width() / room.width(), seen.height() / room.height()), 1.0, 1e-3);
        EXPECT_NEAR(seen.center().x(), room.center().x(), 0.5);
        EXPECT_NEAR(seen.center().y(), room.center().y(), 0.5);
    }
}

INSTANTIATE_TEST_SUITE_P(Presets, CameraFit,
                         ::testing::Values(ViewPreset::AlongMinusZ, ViewPreset::AlongX,
                                           ViewPreset::Isometric));

// Catches a mirrored picture: the presets' promises about which way the axes point on screen.
TEST(CameraFitDirections, AxesPointAsPromised) {
    const auto step = [](ViewPreset preset, const Eigen::Vector3d& direction) {
        vtkNew<vtkCamera> camera;
        applyPreset(*camera, preset);
        fitCamera(*camera, kBox, {500, 500}, {});
        const Projection projection(*camera, {500, 500});
        return projection(0.1 * direction) - projection(Eigen::Vector3d::Zero());
    };
    EXPECT_GT(step(ViewPreset::AlongMinusZ, Eigen::Vector3d::UnitX()).x(), 10.0);
    EXPECT_LT(step(ViewPreset::AlongMinusZ, Eigen::Vector3d::UnitY()).y(), -10.0);
    EXPECT_LT(step(ViewPreset::AlongX, Eigen::Vector3d::UnitY()).x(), -10.0);
    EXPECT_LT(step(ViewPreset::AlongX, Eigen::Vector3d::UnitZ()).y(), -10.0);
    EXPECT_LT(step(ViewPreset::Isometric, Eigen::Vector3d::UnitZ()).y(), -10.0);
}

// Catches a division by zero when a splitter squeezes the view to nothing.
TEST(CameraFitDirections, TinyViewsKeepAUsableCamera) {
    vtkNew<vtkCamera> camera;
    applyPreset(*camera, ViewPreset::Isometric);
    for (const QSizeF size : {QSizeF(0, 0), QSizeF(1, 1), QSizeF(3, 900)})
        fitCamera(*camera, kBox, size, {60, 24, 100, 50});
    EXPECT_GT(camera->GetParallelScale(), 0.0);
    EXPECT_TRUE(std::isfinite(camera->GetParallelScale()));
}

} // namespace
} // namespace bask
