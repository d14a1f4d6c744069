// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/guidestrip.h"

#include "widgets/common/labels.h"
#include "widgets/common/pagekeys.h"
#include "widgets/common/spoken.h"
#include "widgets/common/stateglyph.h"
#include "widgets/common/wraplayout.h"

#include <algorithm>

#include <QGridLayout>
#include <QResizeEvent>

namespace mb {
namespace {

constexpr int roomBeside = 640; ///< of the strip, for its buttons beside its words

} // namespace

GuideStrip::GuideStrip(Shows shows, Guide &guide, const ThemeSource &theme, QWidget *parent)
    : QFrame(parent)
    , m_shows(shows)
    , m_guide(guide)
    , m_theme(theme)
{
    setObjectName(shows == Shows::Offers ? QStringLiteral("guideOffer") : QStringLiteral("guide"));
    setAccessibleName(tr("Guide"));
    setStyleProperty(*this, "banner", QStringLiteral("info"));
    build();
    connect(&guide, &Guide::changed, this, &GuideStrip::follow);
    follow();
}

void GuideStrip::build()
{
    const Theme &theme = m_theme.theme();
    m_grid = new QGridLayout(this);
    QGridLayout *const grid = m_grid;
    grid->setContentsMargins(theme.u(12), theme.u(6), theme.u(12), theme.u(6));
    grid->setHorizontalSpacing(theme.u(12));
    grid->setVerticalSpacing(theme.u(2));
    m_glyph = new StateGlyph(m_theme, GlyphState::Busy, this);
    m_title = textLabel({}, TextRole::Emphasis, Tone::Text, this);
    m_steps = new ElidedLabel({}, this);
    m_steps->setObjectName(QStringLiteral("guideSteps"));
    setTone(*m_steps, Tone::Dim);
    m_words = textLabel({}, TextRole::Body, Tone::Text, this);
    m_words->setObjectName(QStringLiteral("guideWords"));
    m_words->setWordWrap(true);
    m_buttons = new QWidget(this);
    auto *row = new WrapLayout(m_buttons);
    row->setContentsMargins(0, 0, 0, 0);
    m_act = new CommandButton(m_theme, tr("Show me where"), m_buttons);
    m_act->setTextVariants({tr("Show me where"), tr("Begin")});
    m_leave = new CommandButton(m_theme, tr("Dismiss"), m_buttons);
    m_leave->setTextVariants({tr("Dismiss"), tr("Not now"), tr("Close")});
    row->addWidget(m_act);
    row->addWidget(m_leave);
    arrange();
    connect(m_act, &QPushButton::clicked, this, &GuideStrip::act);
    connect(m_leave, &QPushButton::clicked, this, &GuideStrip::leave);
}

/// The buttons beside the words, or, where these would get too narrow, below them.
void GuideStrip::arrange()
{
    const bool beside = width() >= m_theme.theme().u(roomBeside);
    for (QWidget *part : std::initializer_list<QWidget *>{m_glyph, m_title, m_steps, m_words, m_buttons})
        m_grid->removeWidget(part);
    const int across = beside ? 1 : 3;
    m_grid->addWidget(m_glyph, 0, 0);
    m_grid->addWidget(m_title, 0, 1, 1, across);
    m_grid->addWidget(m_steps, beside ? 0 : 1, beside ? 2 : 1, 1, across);
    m_grid->addWidget(m_words, beside ? 1 : 2, 1, 1, beside ? 2 : 3);
    if (beside)
        m_grid->addWidget(m_buttons, 0, 3, 2, 1, Qt::AlignVCenter);
    else
        m_grid->addWidget(m_buttons, 3, 1, 1, 3);
    m_buttons->setSizePolicy(beside ? QSizePolicy::Maximum : QSizePolicy::Preferred, QSizePolicy::Preferred);
    m_buttons->setMinimumWidth(beside ? m_buttons->sizeHint().width() : 0);
    m_grid->setColumnStretch(2, 1);
}

void GuideStrip::offer(const Story *story)
{
    if (m_offer == story)
        return;
    m_offer = story;
    follow();
}

void GuideStrip::follow()
{
    const bool playing = m_shows == Shows::Steps && m_guide.story();
    const bool offering = m_shows == Shows::Offers && m_offer && !m_guide.story();
    setVisible(playing || offering);
    if (playing)
        showSteps();
    else if (offering)
        showOffer();
    m_act->setPrimary(!playing);
}

void GuideStrip::showOffer()
{
    m_glyph->setState(GlyphState::Waiting);
    m_title->setText(storyText(*m_offer, m_offer->title));
    m_steps->hide(); // an empty line would stand below the title
    setWords(storyText(*m_offer, m_offer->words) + QLatin1Char(' ')
        + tr("Simulated: nothing real moves. A guide says each step and waits until it has happened."));
    m_act->setText(tr("Begin"));
    m_act->show();
    m_leave->setText(tr("Not now"));
}

void GuideStrip::showSteps()
{
    const Story &story = *m_guide.story();
    const bool done = m_guide.isDone();
    m_glyph->setState(done ? GlyphState::Done : GlyphState::Busy);
    m_title->setText(storyText(story, story.title));
    QStringList steps;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        const QString name = storyText(story, story.steps[i].name);
        if (i < m_guide.step())
            steps += tr("%1 done").arg(name);
        else if (i == m_guide.step())
            steps += tr("%1. %2").arg(i + 1).arg(name);
        else
            steps += name;
    }
    m_steps->show();
    m_steps->setText(steps.join(QStringLiteral("  ·  ")));
    QString words;
    if (done) {
        words = tr("Done.");
    } else if (!m_guide.device()) {
        words = tr("The simulated bench is opened; the unit answers in a moment.");
    } else {
        const StoryStep &step = story.steps[m_guide.step()];
        words = storyText(story, step.words, m_keyOf ? m_keyOf(step) : QString::fromLatin1(step.key));
    }
    if (const QString result = m_guide.result(); !result.isEmpty())
        words += QLatin1Char(' ') + tr("Measured: %1.").arg(result);
    setWords(words);
    m_act->setText(tr("Show me where"));
    m_act->setVisible(!done);
    m_leave->setText(done ? tr("Close") : tr("Dismiss"));
}

/// Whole, in as many lines as they need: the page below gives the room.
void GuideStrip::setWords(const QString &words)
{
    m_words->setText(words);
    m_words->setMinimumHeight(std::max(0, m_words->heightForWidth(m_words->width())));
    setSpoken(*this, accessibleName(), words);
}

void GuideStrip::setKeys(KeyOf keyOf)
{
    m_keyOf = std::move(keyOf);
    follow();
}

bool GuideStrip::event(QEvent *event)
{
    if (event->type() == keysChanged())
        follow();
    return QFrame::event(event);
}

void GuideStrip::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    const int limit = m_theme.theme().u(roomBeside);
    if ((event->oldSize().width() >= limit) != (width() >= limit))
        arrange();
    m_words->setMinimumHeight(std::max(0, m_words->heightForWidth(m_words->width())));
}

void GuideStrip::act()
{
    if (m_shows == Shows::Steps && m_guide.story() && !m_guide.isDone())
        Q_EMIT placeWanted(m_guide.story()->steps[m_guide.step()].place);
    else if (m_offer)
        Q_EMIT wanted(*m_offer);
}

void GuideStrip::leave()
{
    if (m_shows == Shows::Steps) {
        m_guide.end();
        return;
    }
    m_offer = nullptr;
    follow();
    Q_EMIT refused();
}

} // namespace mb
