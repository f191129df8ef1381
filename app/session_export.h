#pragma once
// Exports a recorded session in another form from the window.

#include "app/drawing/session_outputs.h"
#include "widgets/common/latest_job.h"
#include "widgets/plots/plot_table.h"
#include "widgets/review/session_form.h"

#include <QByteArray>
#include <QObject>
#include <QStringList>

#include <deque>
#include <functional>
#include <map>
#include <utility>

namespace bask {

/// Header of the last column of a plot's table, by which the file is known again.
inline const QString kPlotTableMark = QStringLiteral("exported by Bask");

/// Reads and computes off the GUI thread; figures and reports are drawn on it, which takes up to a minute for
/// a run of 24 h.
class SessionExport : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    static bool isReport(SessionForm form);
    /// Whether the form is drawn on the GUI thread.
    static bool isDrawn(SessionForm form) { return form == SessionForm::Figures || isReport(form); }

    /// Sets a check that is called after reading, before drawing. If it returns false, nothing is drawn, and
    /// the check itself tells the person.
    void setDrawGuard(std::function<bool()> mayDraw) { m_mayDraw = std::move(mayDraw); }

    /// Exports to a folder, a report to a file that ends in .html or .pdf, NeXus to one that ends in .nxs.
    /// `language` is the window's, `layout` that of figures. Several forms may be exported at the same time.
    void start(SessionForm form, const QString& session, const QString& to, TemperatureUnit unit,
               const QString& language, const FigureLayout& layout = {});
    /// Refuse to replace what Bask has not written. Error: OutputForeign.
    static Result<void> checkComparison(const std::string& path);
    static Result<void> checkFigure(const std::string& path);
    static Result<void> checkTable(const std::string& path);

    /// Writes a comparison of metrics, as ComparisonView makes it.
    void writeComparison(const QString& csv, const QString& to);
    /// Writes what a plot shows: its figure, with kRunFigureMark, or its table, with kPlotTableMark, for
    /// which recordings are read.
    void writeFigure(const QByteArray& bytes, const QString& to);
    void writeTable(const PlotTable& table, const QString& to);

    /// Returns the files and folders that are not written yet. With this object what is not finished ends: a
    /// file is written as a whole or not at all.
    QStringList unfinished() const;

signals:
    void problem(const QString& sentence);
    /// The files are there.
    void exported(const QString& sentence, const QStringList& files);

private:
    using Files = Result<std::vector<std::string>>;
    struct Output {
        QString to;
        LatestJob<Files>::Work work;
    };
    /// One after another: each is written and told.
    struct Queue {
        std::deque<Output> unfinished; ///< the first is being written
        LatestJob<Files> job;
    };
    /// What is read before it is drawn, and where it goes.
    struct Drawing {
        QString to;
        LatestJob<Result<RunReportInput>>::Work read;
        LatestJob<Result<RunReportInput>>::Done draw;
    };
    /// One after another.
    struct Drawings {
        std::deque<Drawing> unfinished; ///< the first is being read
        LatestJob<Result<RunReportInput>> input;
    };
    void write(Queue& queue, const QString& to, LatestJob<Files>::Work work);
    void writeNext(Queue& queue);
    void drawNext(Drawings& drawings);
    void tell(const Files& files, const QString& to);

    std::function<bool()> m_mayDraw;
    std::map<SessionForm, Queue> m_files;
    Queue m_small;  ///< comparisons and figures
    Queue m_tables; ///< a long run is read for minutes
    std::map<SessionForm, Drawings> m_drawings;
};

} // namespace bask
