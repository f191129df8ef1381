#pragma once
// A camera's intrinsics: takes views of a board, solves off the GUI thread, judges the result, keeps it in
// files.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace bask {

class BoardForm;
class CameraResult;
class CoverageView;
class MessageBar;
class ViewList;

/// Receives the progress of fits from the pool's thread.
class FitProgress : public QObject {
    Q_OBJECT
signals:
    void fitted(int done, int of);
};

/// After a camera was requested, every view added or left out solves it again, so that the shown result
/// belongs to the ticked views. Object names: "captureStart", "captureAutomatic", "captureTake",
/// "captureStatus", "captureAgain", "cameraMessage" (MessageBar), "solve", "solveProgress", "solveCancel",
/// "leaveOut", and those of BoardForm, CoverageView, ViewList, CameraResult.
class CameraPanel : public QWidget {
    Q_OBJECT

public:
    explicit CameraPanel(QWidget* parent = nullptr);
    ~CameraPanel() override;

    /// Takes what the camera shows; each frame counts once. Another name is another camera.
    void setView(const VisionView& view);
    /// Drops the views, and what was computed from them or read from a file: they are of another camera.
    void changeCamera();
    /// Sets the distance from camera to source at which errors are given in mm; 0.6 m by default.
    void setDistance(double distance_m);
    /// The camera in use.
    void setCamera(const std::optional<CameraModel>& camera);
    /// Sets the available board, such as one printed and measured. The views of another board are dropped.
    void setBoard(const Board& board);

    /// Files are read and written off the GUI thread; the panel shows errors.
    void loadCamera(const QString& path);
    void saveCamera(const QString& path, bool asRos);

signals:
    /// Search for this board in the pictures; empty for no board.
    void boardWanted(const std::optional<bask::Board>& board);
    void cameraChosen(const bask::CameraModel& camera);
    /// The heat map to draw over the picture; empty for none.
    void heatMapChanged(const std::optional<bask::HeatMap>& map);
    /// This part of the panel must be seen.
    void attentionWanted(QWidget* part);
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* buildBoard();
    QWidget* buildCapture();
    QWidget* buildViews();
    QWidget* buildResult();
    void connectAll();
    bool isCapturing() const;
    void changeBoard();
    void startAgain();
    void capture(bool on);
    bool startCollector(const GreyPicture& picture);
    void look();
    void take();
    void added();
    void showViews();
    void solve();
    void cancel();
    void taken(Result<CameraCalibration> result, const std::vector<int>& rows);
    void leaveOut();
    void askWhereToSave();
    void askWhatToLoad();
    void sayOther();
    void sayStatus(const QString& sentence);
    void updateEnabled();
    void retranslate();

    VisionView m_view; ///< the newest view
    std::optional<ViewCollector> m_collector;
    std::optional<Board> m_other; ///< board offered instead of the selected one
    bool m_cameraWanted = false;  ///< solve again when views change
    bool m_isAsked = false;       ///< a person waits for the result: show it
    std::vector<int> m_outstanding;

    LatestJob<Result<CameraCalibration>> m_solving;
    LatestJob<Result<CameraModel>> m_loading;
    LatestJob<Result<void>> m_saving;

    BoardForm* m_board;
    QPushButton* m_start;
    QCheckBox* m_automatic;
    QPushButton* m_take;
    QLabel* m_status;
    MessageBar* m_message;
    CoverageView* m_coverage;
    ViewList* m_list;
    QPushButton* m_leaveOut;
    QPushButton* m_again;
    QPushButton* m_solve;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    CameraResult* m_result;
    QLabel* m_boardTitle;
    QLabel* m_viewsTitle;
    QLabel* m_resultTitle;
};

} // namespace bask
