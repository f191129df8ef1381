#pragma once
// One object in large figures: what its tile on the Run page shows.

#include "engine/base/units.h"
#include "widgets/common/object_tile.h"

#include <QFrame>

namespace bask {

class LargeText;

/// Judges nothing: a temperature that the tile shows as not known is grey here, with the mark of unknown
/// values, and its word and age. Object names: the tile "largeTile.<index>"; inside "largeName",
/// "largeTemperature", "largeWord", "largeTarget", "largeError" and their captions.
class LargeTile : public QFrame {
    Q_OBJECT
public:
    LargeTile(int index, QWidget* parent);

    void setShown(const ShownObject& shown, TemperatureUnit unit);
    /// Height of a figure of the temperature in px if the tile were this large.
    int figureHeight(QSize size) const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void setCaptions(const QString& widest);
    void arrange();

    int m_index;
    ObjectActivity m_activity = ObjectActivity::Waiting;
    QRect m_swatch;   ///< of the object's line in the traces
    QString m_widest; ///< of target and error
    LargeText *m_name, *m_temperature, *m_word, *m_targetCaption, *m_target, *m_errorCaption, *m_error;
};

} // namespace bask
