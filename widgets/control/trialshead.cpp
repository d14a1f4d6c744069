// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/control/trialshead.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/layoutin.h"
#include "widgets/control/trialpair.h"
#include "widgets/plots/plotstack.h"

#include <QLabel>

namespace mb {

TrialsHead::TrialsHead(PlotStack &stack, const ThemeSource &source, QWidget *parent)
    : QWidget(parent)
    , m_legend(new CurveLegend(source, {}, this))
    , m_words(textLabel({}, TextRole::Caption, Tone::Dim, this))
{
    const Theme &theme = source.theme();
    auto *row = layoutIn<QHBoxLayout>(this, -1, {0, theme.u(2), theme.u(8), theme.u(2)});
    row->addWidget(m_legend, 1);
    row->addWidget(m_words);
    const auto add = [&](Symbol symbol, const QString &text, const QString &key) {
        auto *button = new IconButton(source, symbol, text, this);
        button->setKeyHint(key);
        row->addWidget(button);
        return button;
    };
    const auto *const flip = add(Symbol::Swap, tr("Flip A and B"), QStringLiteral("B"));
    const auto *const pin = add(Symbol::Pin, tr("Pin B as A"), QStringLiteral("A"));
    auto *const cursors = add(Symbol::Cursors, tr("Cursors A and B"), QStringLiteral("L"));
    const auto *const fit = add(Symbol::Fit, tr("Fit time and value"), QStringLiteral("0"));
    cursors->setCheckable(true);
    connect(flip, &QToolButton::clicked, this, &TrialsHead::flipRequested);
    connect(pin, &QToolButton::clicked, this, &TrialsHead::pinRequested);
    connect(cursors, &QToolButton::toggled, &stack, &PlotStack::setCursorsShown);
    connect(
        &stack, &PlotStack::cursorsChanged, cursors, [&stack, cursors] { cursors->setChecked(stack.cursorsShown()); });
    connect(fit, &QToolButton::clicked, &stack, [&stack] { stack.fit(); });
}

void TrialsHead::show(const TrialPair &pair, const std::vector<CurveLegend::Entry> &legend)
{
    const KeptTrial *const a = pair.a();
    const KeptTrial *const b = pair.b();
    m_words->setText(!b                 ? tr("No trial yet. Run makes the first.")
            : a && !pair.isComparable() ? tr("A #%1 is another stimulus, it is not drawn").arg(a->number)
            : a                         ? QString()
                                        : tr("Shift+click on a trial pins it as A"));
    m_words->setHidden(m_words->text().isEmpty());
    m_legend->setEntries(legend);
}

} // namespace mb
