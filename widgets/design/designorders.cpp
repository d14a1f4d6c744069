// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/design/designorders.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/segmented.h"
#include "widgets/common/wraplayout.h"

#include <QEvent>
#include <QSignalBlocker>

#include <algorithm>
#include <array>

namespace mb {
namespace {

constexpr std::array designedLoops{Mode::Velocity, Mode::Position, Mode::Current}; // in the order of the choice

} // namespace

DesignOrders::DesignOrders(const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_loops(new Segmented(tr("Loop"), {tr("Velocity"), tr("Position"), tr("Current")}, this))
    , m_slots(new Segmented(tr("Gain slot"), {tr("slot 0"), tr("slot 1")}, this))
    , m_identify(new CommandButton(theme, tr("Identify"), this))
    , m_autotune(new CommandButton(theme, tr("Autotune"), this))
    , m_prove(new CommandButton(theme, Symbol::Play, tr("Write and prove"), this))
{
    m_autotune->setToolTip(tr("Identifies, writes the chosen set and proves it, in one go"));
    m_prove->setPrimary(true);
    auto *row = new WrapLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QWidget *part : std::initializer_list<QWidget *>{m_loops, m_slots, m_identify, m_autotune})
        row->addWidget(part);
    setCompact(false);
    connect(m_loops, &Segmented::currentChanged, this,
        [this](int index) { Q_EMIT loopChosen(designedLoops.at(static_cast<std::size_t>(index))); });
    connect(m_slots, &Segmented::currentChanged, this, &DesignOrders::slotChosen);
    connect(m_identify, &QPushButton::clicked, this, &DesignOrders::identifyRequested);
    connect(m_autotune, &QPushButton::clicked, this, &DesignOrders::autotuneRequested);
    connect(m_prove, &QPushButton::clicked, this, &DesignOrders::proveRequested);
}

void DesignOrders::setCompact(bool compact)
{
    m_compact = compact;
    layout()->setSpacing(fontMetrics().height() / (compact ? 4 : 2));
    m_identify->setKeyHint(compact ? QString() : QStringLiteral("Shift+F6"));
    m_autotune->setKeyHint(compact ? QString() : QStringLiteral("F6"));
    m_prove->setKeyHint(compact ? QString() : QStringLiteral("F5"));
    fold();
}

bool DesignOrders::event(QEvent *event)
{
    if (event->type() == QEvent::LayoutRequest) // other words in it, one slot more
        fold();
    return QWidget::event(event);
}

void DesignOrders::fold()
{
    const int gap = layout()->spacing();
    int needed = m_loops->unfoldedWidth() + gap + m_identify->sizeHint().width() + gap + m_autotune->sizeHint().width();
    needed += m_slots->isHidden() ? 0 : m_slots->unfoldedWidth() + gap;
    for (Segmented *choice : {m_loops, m_slots})
        choice->setFolded(m_compact && needed > width());
}

QWidget *DesignOrders::proveButton() const
{
    return m_prove;
}

void DesignOrders::follow(const DesignBook &book, const Family &family, bool mayRun, bool mayProve)
{
    const QSignalBlocker noLoop(m_loops), noSlot(m_slots); // nobody chooses here
    const auto *const loop = std::ranges::find(designedLoops, book.loop());
    m_loops->setCurrent(static_cast<int>(loop - designedLoops.begin()));
    m_slots->setVisible(family.capabilities.gainSlots > 1);
    m_slots->setCurrent(book.choice().slot);
    m_identify->setEnabled(mayRun);
    m_autotune->setEnabled(mayRun);
    m_prove->setEnabled(mayRun && mayProve);
}

} // namespace mb
