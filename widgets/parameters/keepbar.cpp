// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/keepbar.h"

#include "settings/confirmation.h"
#include "widgets/common/devicetext.h"
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"

#include <QGridLayout>
#include <QPointer>
#include <QProgressBar>
#include <QShortcut>

#include <algorithm>
#include <cmath>

namespace mb {
namespace {

using State = UnconfirmedView::State;

constexpr int leastWords = 360;

QString stateText(const UnconfirmedView &view)
{
    switch (view.state) {
    case State::Offered: return KeepBar::tr("nothing goes back by itself");
    case State::AwaitsRestart: return KeepBar::tr("30 s from when the unit has restarted with them");
    case State::Counting: return KeepBar::tr("they go back in %1 s").arg(static_cast<int>(std::ceil(view.left)));
    case State::AwaitsStandstill: return KeepBar::tr("they go back as soon as the motor stands");
    }
    return {};
}

} // namespace

KeepBar::KeepBar(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_workbench(workbench)
    , m_theme(theme)
    , m_question(new ElidedLabel({}, this))
    , m_countdown(textLabel({}, TextRole::Emphasis, Tone::Caution, this))
    , m_values(new ElidedLabel({}, this))
    , m_time(new QProgressBar(this))
    , m_keep(new CommandButton(theme, tr("Keep"), this))
    , m_back(new CommandButton(theme, Symbol::Undo, tr("Revert"), this))
{
    setObjectName(QStringLiteral("keepBar"));
    setProperty("banner", QStringLiteral("caution"));
    setTextRole(*m_question, TextRole::Emphasis);
    setTone(*m_values, Tone::Dim);
    m_values->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto *sentence = new QHBoxLayout; // what is left of the time is never cut, rather the name
    sentence->setSpacing(theme.theme().u(6));
    sentence->addWidget(m_question);
    sentence->addWidget(m_countdown);
    sentence->addStretch(1);
    m_time->setTextVisible(false);
    m_time->setRange(0, static_cast<int>(settings::confirmTime / std::chrono::milliseconds(1)));
    m_time->setAccessibleName(tr("Time until the values go back"));
    m_time->setFixedHeight(theme.theme().u(8));
    m_keep->setPrimary(true);
    m_keep->setKeyHint(QStringLiteral("Ctrl+Enter"));
    auto *grid = m_grid = new QGridLayout(this);
    const int edge = theme.theme().u(12);
    grid->setContentsMargins(edge, theme.theme().u(6), edge, theme.theme().u(6));
    grid->setHorizontalSpacing(edge);
    auto *glyph = new StateGlyph(theme, GlyphState::Waiting, this);
    grid->addWidget(glyph, 0, 0, 2, 1);
    grid->addLayout(sentence, 0, 1, 1, 2);
    grid->addWidget(m_time, 1, 1);
    grid->addWidget(m_values, 1, 2);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 2);
    connect(m_keep, &QPushButton::clicked, this, &KeepBar::keep);
    connect(m_back, &QPushButton::clicked, this, &KeepBar::putBack);
    connect(&workbench, &Workbench::changed, this, &KeepBar::follow);
    for (const char *keys : {"Ctrl+Return", "Ctrl+Enter"}) { // of the letters, and of the numbers
        auto *key = new QShortcut(QKeySequence(QLatin1String(keys)), this);
        key->setContext(Qt::WindowShortcut);
        key->setAutoRepeat(false);
        connect(key, &QShortcut::activated, this, [this] {
            if (!m_keep->isFresh())
                keep();
        });
    }
    hide();
    placeButtons();
    follow();
}

void KeepBar::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    placeButtons();
}

/// Behind the words, or below them where those would have no room.
void KeepBar::placeButtons()
{
    const int buttons = m_keep->sizeHint().width() + m_back->sizeHint().width();
    const bool below = width() < buttons + m_theme.theme().u(leastWords);
    if (m_below == below)
        return;
    m_below = below;
    for (CommandButton *button : {m_keep, m_back})
        m_grid->removeWidget(button);
    m_grid->addWidget(m_keep, below ? 2 : 0, below ? 1 : 3, below ? 1 : 2, 1);
    m_grid->addWidget(m_back, below ? 2 : 0, below ? 2 : 4, below ? 1 : 2, 1);
}

QString KeepBar::question() const
{
    return isHidden() ? QString() : m_question->text() + QLatin1Char(' ') + m_countdown->text();
}

const UnconfirmedView *KeepBar::first() const
{
    const auto &all = m_workbench.snapshot().unconfirmed;
    const auto urgency = [](const UnconfirmedView &view) {
        return view.state == State::Counting ? view.left : view.state == State::AwaitsStandstill ? -1.0 : 1e9;
    };
    const auto found = std::ranges::min_element(
        all, [&urgency](const UnconfirmedView &a, const UnconfirmedView &b) { return urgency(a) < urgency(b); });
    return found == all.end() ? nullptr : &*found;
}

void KeepBar::follow()
{
    const UnconfirmedView *view = first();
    setVisible(view != nullptr);
    if (view)
        showChange(*view, static_cast<int>(m_workbench.snapshot().unconfirmed.size()) - 1);
}

void KeepBar::showChange(const UnconfirmedView &view, int more)
{
    const DeviceView *device = m_workbench.snapshot().device(view.device);
    if (m_device != view.device || m_change != view.change) { // the same words, of something else
        m_keep->changeRole();
        m_back->changeRole();
    }
    m_device = view.device;
    m_change = view.change;
    m_question->setText(tr("Keep these values of %1?").arg(device ? titleOf(*device) : QString()));
    m_question->setToolTip(m_question->text());
    m_countdown->setText(stateText(view));
    m_countdown->setMinimumWidth(m_countdown->sizeHint().width());
    const QString caveat = view.state == State::Offered ? placeCaveat(view.unit) : QString();
    const QString values = caveat + messageText(view.text);
    m_values->setText(more > 0 ? tr("%1 · %n more change(s) after this one", nullptr, more).arg(values) : values);
    m_values->setToolTip(m_values->text());
    m_time->setVisible(view.state == State::Counting || view.state == State::AwaitsRestart);
    m_time->setValue(static_cast<int>(view.left * 1000.0));
    setSpoken(*this, question(), m_values->text());
}

void KeepBar::keep()
{
    if (isHidden())
        return;
    m_workbench.send(orders::KeepChange{m_device, m_change});
}

void KeepBar::putBack()
{
    if (!isHidden())
        m_workbench.send(orders::PutBackChange{m_device, m_change});
}

} // namespace mb
