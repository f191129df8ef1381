#pragma once
// The Review page with the run that is open, its numbers and the list of runs.

#include "app/alarm_history_control.h"
#include "app/document.h"
#include "app/overlay_count.h"
#include "app/session_actions.h"
#include "app/session_count.h"
#include "app/session_library.h"
#include "app/session_verification.h"

#include <QObject>

#include <memory>
#include <optional>

namespace bask {

class ReviewPage;

class ReviewDesk : public QObject {
    Q_OBJECT

public:
    ReviewDesk(ReviewPage& page, Document& document, SessionActions& files, QObject* parent = nullptr);

    void showList();                        ///< shows the list of the sessions' folder
    void refreshList();                     ///< reads it again, and says so once it is shown
    void showAlarmsOnceListed();            ///< the alarms of the listed runs, with the next list
    void forgetAlarms();                    ///< the page was left before they were shown
    void setRecording(const QString& path); ///< the file that is being recorded; empty for none
    void setEditable(bool editable) { m_editable = editable; } ///< whether the open experiment can be edited
    void retranslate();

signals:
    void opening(); ///< another session is being opened: earlier messages no longer apply
    void opened();  ///< the session is shown
    void problem(const QString& sentence);
    void told(const QString& sentence);
    void toldAside(const QString& sentence); ///< nothing that has to be read
    /// Opens a page of the manual, such as "manual.md#review".
    void manualRequested(const QString& page);

private:
    void connectList();
    void connectCount();
    void connectVerification();
    void pauseLibrary();
    void open(std::shared_ptr<RecordedSession> session, std::optional<double> at_s);
    bool isOpen(const QString& path) const;
    void showSession();
    void showIdentified();
    void useIdentified();

    ReviewPage& m_page;
    Document& m_document;
    SessionActions& m_files;
    SessionLibrary m_library;
    SessionCount m_count;
    OverlayCount m_overlayCount;
    SessionVerification m_verification;
    AlarmHistoryControl m_alarms;
    QMetaObject::Connection m_onceListed;    ///< of the alarms that wait for the list
    QMetaObject::Connection m_onceRefreshed; ///< of a person who does
    QString m_recording;
    std::shared_ptr<RecordedSession> m_session;
    QString m_comparedPath; ///< the run that is being opened for a comparison with m_comparedOver
    QStringList m_comparedOver;
    /// numbers of m_session; null if they are being computed or not available
    std::shared_ptr<const SessionNumbers> m_numbers;
    bool m_isDamageTold = false; ///< the damage of m_session was reported
    bool m_editable = true;
};

} // namespace bask
