#pragma once
// A QOpenGLWidget that shows a VTK renderer; private to widgets/scene.

#include <QMarginsF>
#include <QOpenGLWidget>

#include <functional>
#include <memory>

class QPainter;
class vtkRenderer;

namespace bask {

/// Draws the renderer into Qt's framebuffer, then lets a painter draw over it. Mouse, wheel and keys turn the
/// camera (trackball): left turns, middle or Shift+left moves, right or wheel zooms; arrows turn, + and -
/// zoom, Home resets.
///
/// Nothing is drawn from within a call: requestFrame() asks for a frame, frames asked for in quick succession
/// become one, and a hidden view draws none. Resources are made when there is an OpenGL context and freed
/// with it current, as often as Qt makes a new one (moving to another window).
class VtkView : public QOpenGLWidget {
    Q_OBJECT
public:
    static constexpr int kFrameInterval_ms = 66;       ///< between frames requested by data
    static constexpr int kInteractionInterval_ms = 30; ///< between frames requested by the mouse

    explicit VtkView(QWidget* parent = nullptr);
    ~VtkView() override;

    /// Whether this computer provides an OpenGL 3.2 context. Checked once; ask before creating a view.
    static bool available();

    vtkRenderer& renderer();

    /// Sets a function called on the GUI thread just before each frame, outside any setter: update actors
    /// there.
    void setPrepare(std::function<void()> prepare);
    /// Sets a function called after VTK has drawn; the painter works in logical pixels of the widget.
    void setOverlay(std::function<void(QPainter&)> overlay);

    /// Requests a frame soon. Cheap; call it for every change.
    void requestFrame(int interval_ms = kFrameInterval_ms);

    /// Number of frames drawn so far, and the time of the last one in paintGL (s).
    int frames() const;
    double lastFrame_s() const;

signals:
    void cameraMoved();          ///< a person moved the camera
    void clicked(QPointF place); ///< left button pressed and released at one place, logical pixels
    void cameraResetRequested(); ///< Home was pressed
    void failed();               ///< VTK could not use the context; the view stays empty

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void releaseGL();
    void syncSize();
    void tellPosition(QPointF position, Qt::KeyboardModifiers modifiers);
    void releaseButton();
    bool blit();

    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
