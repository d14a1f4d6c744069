// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/ramblock.h"

#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/common/numberformat.h"
#include "widgets/parameters/changerow.h"

#include <QProgressBar>
#include <QTimer>

namespace mb {
namespace {

constexpr std::chrono::milliseconds tickPeriod{250};
constexpr std::size_t rowsShown = 12;

} // namespace

RamBlock::RamBlock(const ThemeSource &theme, std::function<Instant()> now, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_now(std::move(now))
    , m_timer(new QTimer(this))
{
    build();
    m_timer->setInterval(tickPeriod);
    connect(m_timer, &QTimer::timeout, this, &RamBlock::tick);
    connect(m_store, &QPushButton::clicked, this, &RamBlock::storeRequested);
    hide();
}

void RamBlock::build()
{
    const Theme &t = m_theme.theme();
    auto *column = layoutIn<QVBoxLayout>(this, t.u(6), {t.u(12), t.u(12), t.u(12), t.u(12)});
    auto *head = new QHBoxLayout;
    head->addWidget(new SectionLabel(tr("In RAM, not in flash"), this));
    head->addStretch();
    m_left = new QLabel(this);
    setTextRole(*m_left, TextRole::Caption);
    setTone(*m_left, Tone::Caution);
    head->addWidget(m_left);
    column->addLayout(head);
    m_bar = new QProgressBar(this);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Time until the device stores by itself"));
    setStyleProperty(*m_bar, "tone", QStringLiteral("caution"));
    column->addWidget(m_bar);
    m_grid = new QGridLayout;
    m_grid->setColumnStretch(0, 1);
    m_grid->setVerticalSpacing(t.u(3));
    column->addLayout(m_grid);
    m_hint = textLabel({}, TextRole::Caption, Tone::Dim, this);
    m_hint->setWordWrap(true);
    column->addWidget(m_hint);
    m_store = new CommandButton(m_theme, Symbol::Save, tr("Store and prove"), this);
    m_store->setKeyHint(QStringLiteral("Ctrl+S"));
    column->addWidget(m_store);
}

void RamBlock::show(State state)
{
    m_state = std::move(state);
    const auto held = m_state.family ? inRam(*m_state.parameters) : std::vector<ParameterIndex>();
    m_held = held.size();
    setVisible(!held.empty());
    if (held.empty()) {
        m_timer->stop();
        return;
    }
    fillRows(held);
    m_store->setEnabled(m_state.mayStore);
    tick();
}

void RamBlock::fillRows(const std::vector<ParameterIndex> &held)
{
    const std::size_t shown = std::min(held.size(), rowsShown);
    while (m_labels.size() < 2 * shown) {
        auto *key = textLabel({}, TextRole::Raw, Tone::Text, this);
        auto *values = new QLabel(this);
        values->setTextFormat(Qt::RichText);
        setTone(*values, Tone::Dim);
        const int row = static_cast<int>(m_labels.size() / 2);
        m_grid->addWidget(key, row, 0);
        m_grid->addWidget(values, row, 1, Qt::AlignRight);
        m_labels.insert(m_labels.end(), {key, values});
    }
    for (std::size_t i = 0; i < m_labels.size(); ++i)
        m_labels[i]->setVisible(i < 2 * shown);
    for (std::size_t i = 0; i < shown; ++i) {
        const ParameterStore::Entry &entry = (*m_state.parameters)[held[i].value];
        const Parameter &parameter = m_state.family->parameters[held[i].value];
        m_labels[2 * i]->setText(qt(parameter.key));
        m_labels[2 * i + 1]->setText(transitionText(
            entry.flash ? valueText(parameter, *entry.flash) : QString(UnknownMark), valueText(parameter, *entry.raw)));
    }
}

void RamBlock::tick()
{
    const auto whole = std::chrono::duration_cast<std::chrono::milliseconds>(m_state.family->capabilities.storesAfter);
    const auto passed = m_state.lastWrite
        ? std::chrono::duration_cast<std::chrono::milliseconds>(m_now() - *m_state.lastWrite)
        : whole;
    const auto left = std::max(whole - passed, std::chrono::milliseconds(0));
    const bool counting = left.count() > 0;
    m_bar->setVisible(counting);
    m_bar->setRange(0, static_cast<int>(whole.count()));
    m_bar->setValue(static_cast<int>((whole - left).count()));
    m_left->setText(counting ? tr("%1 s to go").arg((left.count() + 999) / 1000) : tr("not proved"));
    QString hint = whole.count() == 0 ? tr("Read back and equal. Lost at power-off until it is stored.")
        : counting                    ? tr("Read back and equal. Do not cut power yet.")
                                      : tr("The device should have stored by itself. Its own proof takes up to %1 s.")
                         .arg(m_state.family->capabilities.storeLimit.count());
    if (const auto more = m_held - std::min(m_held, rowsShown); more > 0)
        hint.prepend(tr("%1 more.").arg(more) + QLatin1Char(' '));
    m_hint->setText(hint);
    m_store->setVisible(!counting);
    if (counting != m_timer->isActive())
        counting ? m_timer->start() : m_timer->stop();
}

} // namespace mb
