#include "widgets/targets/cut_controls.h"

#include "widgets/common/verdict_words.h"
#include "widgets/targets/coordinate_slider.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace bask {
namespace {

/// "y = +3.0 cm"
QString placeText(int coordinate, double value) {
    QString text = coordinateText(coordinate, value);
    return text.replace(text.indexOf(u' '), 1, QStringLiteral(" = "));
}

} // namespace

CutControls::CutControls(QWidget* parent)
    : QWidget(parent), m_axes(3), m_object(new QComboBox(this)), m_quantity(new QComboBox(this)),
      m_axis(new QComboBox(this)), m_place(new CoordinateSlider(this)), m_word(new QLabel(this)) {
    m_object->setObjectName("cutObject");
    m_quantity->setObjectName("cutQuantity");
    m_axis->setObjectName("cutAxis");
    m_place->setObjectName("cutPlace");
    m_word->setObjectName("cutWord");
    m_quantity->addItems({QStringLiteral("T"), QStringLiteral("F")});
    m_axis->addItems({"x", "y", "z"});
    m_axis->setCurrentIndex(kY);
    m_place->setMinimumWidth(40);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QComboBox* box : {m_object, m_quantity, m_axis}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        row->addWidget(box);
    }
    row->addWidget(m_place, 1);
    row->addWidget(m_word);
    row->addStretch(0);
    connect(m_object, &QComboBox::currentIndexChanged, this, [this] {
        showRow();
        emit changed();
    });
    connect(m_quantity, &QComboBox::currentIndexChanged, this, &CutControls::changed);
    connect(m_axis, &QComboBox::currentIndexChanged, this, [this] {
        place();
        emit changed();
    });
    connect(m_place, &QSlider::valueChanged, this, [this] {
        showRow();
        emit changed();
    });
    retranslate();
}

void CutControls::setObjects(const QStringList& names) {
    m_names = names;
    retranslate();
}

void CutControls::setAxes(const std::vector<FieldAxis>& axes, const Eigen::Vector3d& home) {
    m_axes = axes;
    m_home = home;
    const QSignalBlocker quiet(m_axis);
    for (int a = 0; a < 3; ++a)
        m_axis->setItemText(a, axisName(m_axes[static_cast<std::size_t>(a)].coordinate));
    place();
}

int CutControls::coordinate() const {
    return m_axes[static_cast<std::size_t>(m_axis->currentIndex())].coordinate;
}

/// The slider over the axis, its place kept if it is on it and was of it.
void CutControls::place() {
    const FieldAxis& axis = m_axes[static_cast<std::size_t>(m_axis->currentIndex())];
    const double min = axis.at(0), max = axis.at(axis.count - 1);
    const QSignalBlocker quiet(m_place);
    m_place->setCoordinate(axis.coordinate, min, max);
    if (m_placed != axis.coordinate)
        m_place->setPlace(m_home[m_axis->currentIndex()]);
    m_placed = object() ? static_cast<int>(axis.coordinate) : -1;
    showRow();
}

std::optional<int> CutControls::object() const {
    const int object = m_object->currentIndex() - 1;
    return object < 0 ? std::nullopt : std::optional(object);
}

std::optional<CutChoice> CutControls::choice() const {
    if (!object())
        return std::nullopt;
    return CutChoice{*object(), static_cast<Coordinate>(coordinate()), m_place->place(),
                     m_quantity->currentIndex() == 0};
}

void CutControls::showRow() {
    for (QWidget* widget : std::initializer_list<QWidget*>{m_quantity, m_axis, m_place, m_word})
        widget->setVisible(object().has_value());
    m_word->setText(placeText(coordinate(), m_place->place()));
    m_word->setMinimumWidth(
        QFontMetrics(m_word->font())
            .horizontalAdvance(placeText(coordinate(), coordinate() < kThetaX ? -0.288 : -1.5)));
}

void CutControls::retranslate() {
    const int chosen = m_object->currentIndex();
    const QSignalBlocker quiet(m_object);
    m_object->clear();
    m_object->addItem(tr("No cut"));
    const QFontMetrics metrics(m_object->font());
    for (const QString& name : m_names)
        m_object->addItem(tr("Cut: %1").arg(metrics.elidedText(name, Qt::ElideRight, 7 * metrics.height())));
    m_object->setCurrentIndex(chosen > 0 && chosen < m_object->count() ? chosen : 0);
    m_object->setAccessibleName(tr("Object whose field is cut"));
    m_object->setToolTip(tr("A plane in the colours of what one object would have there."));
    m_quantity->setAccessibleName(tr("What the cut shows: T, the steady temperature, or F, the view factor"));
    m_quantity->setToolTip(tr("T: the temperature that the object settles at there. F: its view factor."));
    m_axis->setAccessibleName(tr("Axis that the plane is square to"));
    m_place->setAccessibleName(tr("Place of the plane along its axis"));
    showRow();
}

void CutControls::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
