// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/common/segmented.h"

#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QCursor>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>

#include <algorithm>
#include <numeric>

namespace mb {
namespace {

/// As wide as its bold text, so that the row does not move when another segment is chosen. Where there is less room its padding goes,
/// and then the page scrolls: a choice that cannot be read is none.
class SegmentButton : public QToolButton {
public:
    using QToolButton::QToolButton;
    QSize sizeHint() const override
    {
        return {bold().horizontalAdvance(text()) + bold().height() * 3 / 2, QToolButton::sizeHint().height()};
    }
    QSize minimumSizeHint() const override
    {
        return {bold().horizontalAdvance(text()) + bold().height() * 2 / 3, QToolButton::sizeHint().height()};
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QStylePainter painter(this);
        QStyleOptionToolButton option;
        initStyleOption(&option);
        option.text
            = bold().elidedText(text(), Qt::ElideRight, width() - bold().height() * 2 / 3, Qt::TextShowMnemonic);
        painter.drawComplexControl(QStyle::CC_ToolButton, option);
    }

private:
    QFontMetrics bold() const
    {
        QFont widest = font();
        widest.setBold(true);
        return QFontMetrics(widest);
    }
};

} // namespace

Segmented::Segmented(const QString &accessibleName, QWidget *parent)
    : QWidget(parent)
{
    setAccessibleName(accessibleName);
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_group = new QButtonGroup(this);
    m_row = layoutIn<QHBoxLayout>(this, 0);
    connect(m_group, &QButtonGroup::idToggled, this, [this](int id, bool on) {
        if (!on)
            return;
        if (m_list)
            m_list->setCurrentIndex(id);
        Q_EMIT currentChanged(id);
    });
}

Segmented::Segmented(const QString &accessibleName, const QStringList &texts, QWidget *parent)
    : Segmented(accessibleName, parent)
{
    for (const QString &text : texts)
        addSegment(text);
}

void Segmented::removeLast()
{
    QAbstractButton *last = m_group->button(count() - 1);
    if (!last)
        return;
    const bool wasCurrent = last->isChecked();
    m_group->removeButton(last);
    delete last;
    if (wasCurrent)
        setCurrent(0);
    updateEnds();
    fillList();
}

int Segmented::addSegment(const QString &text)
{
    auto *button = new SegmentButton(this);
    const int id = count();
    button->setText(text);
    button->setAccessibleName(text);
    button->setCheckable(true);
    button->setAutoExclusive(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(m_even ? QSizePolicy::Expanding : QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_group->addButton(button, id);
    m_row->addWidget(button);
    if (m_list)
        button->hide();
    if (id == 0)
        button->setChecked(true);
    updateEnds();
    fillList();
    return id;
}

void Segmented::updateEnds()
{
    const int last = count() - 1;
    for (int i = 0; i <= last; ++i) {
        const char *place = last == 0 ? "only" : i == 0 ? "first" : i == last ? "last" : "middle";
        setStyleProperty(*m_group->button(i), "segment", QLatin1String(place));
    }
}

void Segmented::setText(int index, const QString &text)
{
    if (QAbstractButton *button = m_group->button(index)) {
        button->setText(text);
        button->setAccessibleName(text);
        button->updateGeometry();
        fillList();
    }
}

void Segmented::setSegmentEnabled(int index, bool enabled, const QString &reason)
{
    if (QAbstractButton *button = m_group->button(index)) {
        button->setEnabled(enabled);
        button->setToolTip(enabled ? QString() : reason);
        fillList();
    }
}

void Segmented::setFolded(bool folded)
{
    if (folded == isFolded())
        return;
    if (folded) {
        m_list = new QComboBox(this);
        m_list->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        m_list->setAccessibleName(accessibleName());
        m_row->addWidget(m_list);
        connect(m_list, qOverload<int>(&QComboBox::activated), this, &Segmented::setCurrent);
        fillList();
    } else {
        m_row->removeWidget(m_list);
        m_list->hide();
        m_list->deleteLater(); // it may be what asked for this
        m_list = nullptr;
    }
    const auto buttons = m_group->buttons();
    for (QAbstractButton *button : buttons)
        button->setVisible(!folded);
}

int Segmented::unfoldedWidth() const
{
    const auto buttons = m_group->buttons();
    return std::accumulate(buttons.begin(), buttons.end(), 0,
        [](int sum, const QAbstractButton *button) { return sum + button->sizeHint().width(); });
}

int Segmented::leastUnfoldedWidth() const
{
    const auto buttons = m_group->buttons();
    return std::accumulate(buttons.begin(), buttons.end(), 0,
        [](int sum, const QAbstractButton *button) { return sum + button->minimumSizeHint().width(); });
}

/// The list says what the buttons say; nothing in it changes that is the same.
void Segmented::fillList()
{
    if (!m_list)
        return;
    while (m_list->count() > count())
        m_list->removeItem(m_list->count() - 1);
    while (m_list->count() < count())
        m_list->addItem({});
    auto *const items = qobject_cast<QStandardItemModel *>(m_list->model());
    for (int i = 0; i < count(); ++i) {
        const QAbstractButton &button = *m_group->button(i);
        if (m_list->itemText(i) != button.text()) {
            m_list->setItemText(i, button.text());
            m_list->updateGeometry();
        }
        items->item(i)->setEnabled(button.isEnabled());
        m_list->setItemData(i, button.toolTip(), Qt::ToolTipRole);
    }
    m_list->setCurrentIndex(current());
}

int Segmented::count() const
{
    return m_group->buttons().size();
}

int Segmented::current() const
{
    return m_group->checkedId();
}

void Segmented::setCurrent(int index)
{
    if (QAbstractButton *button = m_group->button(index))
        button->setChecked(true);
}

void Segmented::setEven(bool even)
{
    m_even = even;
    setSizePolicy(even ? QSizePolicy::Preferred : QSizePolicy::Maximum, QSizePolicy::Fixed);
    const auto buttons = m_group->buttons();
    for (QAbstractButton *button : buttons)
        button->setSizePolicy(even ? QSizePolicy::Expanding : QSizePolicy::Maximum, QSizePolicy::Fixed);
}

PageTabs::PageTabs(const ThemeSource &theme, QWidget *parent)
    : QTabBar(parent)
    , m_theme(theme)
{
    setDrawBase(false);
    setExpanding(false);
    setUsesScrollButtons(true);
    setAccessibleName(tr("Pages"));
    setAttribute(Qt::WA_Hover);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    followTheme(theme, *this);
}

void PageTabs::setUnavailable(int index, const QString &reason)
{
    if (isTabEnabled(index) == reason.isEmpty())
        return;
    if (index == currentIndex())
        setCurrentIndex(0);
    setTabEnabled(index, reason.isEmpty());
    setTabToolTip(index, reason.isEmpty() ? tabData(index).toString() : reason);
}

void PageTabs::setHint(int index, const QString &hint)
{
    setTabData(index, hint);
    if (isTabEnabled(index))
        setTabToolTip(index, hint);
}

QFont PageTabs::bold() const
{
    return m_theme.theme().font(TextRole::Emphasis, font());
}

/// Around a word: less before the last page would have to be scrolled for.
int PageTabs::air() const
{
    const QFontMetrics metrics(bold());
    int words = 0;
    for (int i = 0; i < count(); ++i)
        words += metrics.horizontalAdvance(tabText(i));
    return std::clamp((width() - words) / std::max(count(), 1), m_theme.theme().u(8), m_theme.theme().u(22));
}

QSize PageTabs::tabSizeHint(int index) const
{
    return {QFontMetrics(bold()).horizontalAdvance(tabText(index)) + air(), m_theme.theme().u(36)};
}

void PageTabs::paintEvent(QPaintEvent *)
{
    const Theme &theme = m_theme.theme();
    QPainter painter(this);
    const QPoint mouse = mapFromGlobal(QCursor::pos());
    for (int i = 0; i < count(); ++i) {
        const QRect box = tabRect(i);
        const bool current = i == currentIndex();
        const bool hovered = underMouse() && box.contains(mouse);
        painter.setFont(current ? bold() : m_theme.theme().font(TextRole::Body, font()));
        painter.setPen(!isTabEnabled(i) ? theme.faint : current || hovered ? theme.text : theme.dim);
        painter.drawText(box, Qt::AlignCenter, tabText(i));
        if (current)
            painter.fillRect(box.left(), box.bottom() - theme.u(2) + 1, box.width(), theme.u(2), theme.accent);
        if (current && hasFocus()) {
            painter.setPen(QPen(theme.accent, 2));
            painter.drawRoundedRect(box.adjusted(2, 3, -2, -theme.u(4)), theme.u(4), theme.u(4));
        }
    }
}

} // namespace mb
