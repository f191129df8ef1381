#pragma once
// The import of a file of outlines: its picture and outlines, open questions, and the choice of an outline.

#include "engine/shape/contour_import.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <optional>

class QImage;
class QLabel;
class QProgressBar;
class QPushButton;
class QTreeWidget;

namespace bask {

class ImportQuestions;
class MessageBar;
class OutlinePicker;

/// Reads the file off the GUI thread, again after every answer. Object names: "importFile", "importOutlines"
/// (list), "importPicker" (OutlinePicker), "importChosen", "importWarnings", "importProblem" (MessageBar),
/// "importAccept", "importCancel" and those of ImportQuestions.
class ImportPanel : public QWidget {
    Q_OBJECT

public:
    explicit ImportPanel(QWidget* parent = nullptr);

    static bool isReadable(const QString& path);
    /// Starts with a file: it is accepted if there is no question, and refused if no answer helps; otherwise
    /// the panel asks to be shown.
    void open(const QString& path);
    /// Forgets the file; a pending result is discarded.
    void cancel();
    bool isOpen() const { return !m_path.isEmpty(); }

signals:
    void attentionWanted(); ///< the panel must be shown
    void accepted(const QString& path, const bask::PickedOutline& outline);
    void refused(const QString& path, const bask::Error& error);
    void cancelled();

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* buildForm();
    void connectAll();
    void read();
    void take(Result<OutlineFile> file);
    void choose(int index);
    void accept();
    void showOutlines();
    static QString chosenText(const PickedOutline& picked, int number);
    void showChosen();
    void retranslate();
    QString fileName() const;

    QString m_path;
    bool m_asking = false; ///< the operator sees the panel
    LatestJob<Result<OutlineFile>> m_reading;
    LatestJob<QImage> m_loading; ///< loads a picture, before its outlines
    OutlineFile m_file;
    std::optional<Error> m_error; ///< error of reading
    int m_chosen = -1;
    std::optional<Result<PickedOutline>> m_picked; ///< the chosen one, checked

    OutlinePicker* m_picker;
    QLabel* m_title;
    QProgressBar* m_progress;
    ImportQuestions* m_questions;
    QLabel* m_listTitle;
    QTreeWidget* m_list;
    QLabel* m_chosenText;
    QLabel* m_warnings;
    MessageBar* m_problem;
    QPushButton* m_accept;
    QPushButton* m_cancel;
};

} // namespace bask
