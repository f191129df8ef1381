#include "widgets/review/verification_words.h"

#include "engine/base/plain_text.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace bask {
namespace {

constexpr qsizetype kHeadDigitsShown = 8;

struct VerificationWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Verification)
};

/// "view sample", "key outcome".
QString namedText(const SessionFinding& finding) {
    const QString name = QString::fromStdString(printable(finding.name));
    if (finding.type == "key")
        return VerificationWords::tr("key %1").arg(name);
    if (finding.type == "view")
        return VerificationWords::tr("view %1").arg(name);
    if (finding.type == "index")
        return VerificationWords::tr("index %1", "of a database").arg(name);
    if (finding.type == "trigger")
        return VerificationWords::tr("trigger %1", "of a database").arg(name);
    return finding.type == "table" ? VerificationWords::tr("table %1").arg(name) : name;
}

QString placeText(const SessionFinding& finding) {
    QStringList parts;
    if (finding.table == kHeaderTable)
        parts << VerificationWords::tr("the file's header");
    else if (finding.table != "sqlite_master" || finding.name.empty()) // the list of tables
        parts << VerificationWords::tr("table %1").arg(QString::fromStdString(finding.table));
    if (!finding.name.empty())
        parts << namedText(finding);
    else if (finding.row > 0)
        parts << VerificationWords::tr("row %1").arg(QLocale().toString(static_cast<qlonglong>(finding.row)));
    if (finding.time_s && finding.isAfter)
        parts << VerificationWords::tr("after %1", "a time since Start").arg(formatDuration(*finding.time_s));
    else if (finding.time_s)
        parts << VerificationWords::tr("at %1", "a time since Start").arg(formatDuration(*finding.time_s));
    return parts.join(QStringLiteral(", "));
}

QString alterationText(const SessionVerdict& verdict) {
    if (verdict.findings.empty() && verdict.seal == Seal::Removed)
        return VerificationWords::tr(
            "Altered: its seal was removed. Tags, and bytes of the file that are in no "
            "row, may have been changed.");
    if (verdict.findings.empty())
        return VerificationWords::tr(
            "Altered: in tags, or in bytes of the file that are in no row. An older Bask that "
            "changed the tags does that, too.");
    const QString place = placeText(verdict.findings.front());
    const std::int64_t more = verdict.allFindings - 1;
    if (more == 0)
        return VerificationWords::tr("Altered: %1; see bask verify").arg(place);
    return VerificationWords::tr("Altered: %1, and %2 more; see bask verify")
        .arg(place, QLocale().toString(static_cast<qlonglong>(more)));
}

} // namespace

bool isAltered(const SessionVerdict& verdict) {
    return verdict.hasChain && !verdict.isDamaged && !verdict.isIntact();
}

QString verificationText(const SessionVerdict& verdict) {
    if (verdict.isDamaged)
        return VerificationWords::tr("Damaged: bask verify tells what of it can be read");
    if (!verdict.hasChain)
        return VerificationWords::tr("Not verifiable: recorded by an older Bask, without a hash chain");
    if (isAltered(verdict))
        return alterationText(verdict);
    const QString rows = QLocale().toString(static_cast<qlonglong>(verdict.rows));
    const QString head = QString::fromStdString(verdict.head).left(kHeadDigitsShown) + QChar(0x2026);
    return verdict.seal == Seal::Holds
               ? VerificationWords::tr("Intact: %1 rows, sealed, head %2").arg(rows, head)
               : VerificationWords::tr("Intact: %1 rows, not sealed, head %2").arg(rows, head);
}

} // namespace bask
