#pragma once
// A recorded session written in another form from the window.

#include "app/commands/session_outputs.h"
#include "widgets/common/latest_job.h"
#include "widgets/review/session_form.h"

#include <QObject>

namespace bask {

/// Reads and computes off the GUI thread; figures and reports are drawn on it, some seconds of a long run.
class SessionExport : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// To a folder, or of a report to a file that ends in .html or .pdf. `language` is the window's.
    void start(SessionForm form, const QString& session, const QString& to, TemperatureUnit unit,
               const QString& language);

signals:
    void problem(const QString& sentence);
    void told(const QString& sentence);

private:
    using Files = Result<std::vector<std::string>>;
    void tell(const Files& files, const QString& to);

    LatestJob<Files> m_files;
    LatestJob<Result<RunReportInput>> m_input;
};

} // namespace bask
