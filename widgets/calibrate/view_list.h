#pragma once
// The views of a calibration: a small picture each, how far its corners lie off, and whether it counts.

#include <QTreeWidget>

class QImage;

namespace bask {

/// A ticked view counts. Object name: "viewList".
class ViewList : public QTreeWidget {
    Q_OBJECT

public:
    explicit ViewList(QWidget* parent = nullptr);

    /// Next number, counting.
    void add(const QImage& picture);
    int count() const { return topLevelItemCount(); }
    /// `residual_px` none: not known; `standsOut`: marked, in words too.
    void setResidual(int view, std::optional<double> residual_px, bool standsOut);
    bool isUsed(int view) const;
    void setUsed(int view, bool isUsed);

    static constexpr int kPictureWidth = 48, kPictureHeight = 27;

signals:
    void usedChanged(int view, bool isUsed);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showResidual(QTreeWidgetItem* item);
};

} // namespace bask
