// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connection/startpage.h"

#include "widgets/common/iconbutton.h"
#include "widgets/common/layoutin.h"
#include "widgets/connection/doctorcard.h"
#include "widgets/start/storycard.h"

#include <QPushButton>

#include <algorithm>

namespace mb {
namespace {

constexpr int sideWidth = 312;   ///< of the column at the right
constexpr int roomForSide = 900; ///< below it the column stands under the rest
constexpr int storyWidth = 216;  ///< least of a story

} // namespace

StartPage::StartPage(Workbench &workbench, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("startPage"));
    setAccessibleName(tr("Start"));
    const int edge = theme.theme().u(16);
    m_row = new QBoxLayout(QBoxLayout::LeftToRight, this);
    m_row->setContentsMargins(edge, edge, edge, edge);
    m_row->setSpacing(edge);
    m_main = buildMain(workbench);
    m_side = buildSide();
    m_row->addWidget(m_main, 1);
    m_row->addWidget(m_side);
    setRecent({});
    setFirmware({});
}

QWidget *StartPage::buildMain(Workbench &workbench)
{
    auto *main = new QWidget(this);
    m_column = layoutIn<QVBoxLayout>(main, m_theme.theme().u(12));
    m_doctor = new DoctorCard(workbench, m_theme, true, main);
    m_column->addWidget(m_doctor);
    auto *row = new QHBoxLayout;
    auto *add = new CommandButton(m_theme, Symbol::Add, tr("Add link"), main);
    auto *recording = new CommandButton(m_theme, Symbol::Open, tr("Open recording…"), main);
    row->addWidget(add);
    row->addWidget(recording);
    row->addStretch();
    m_column->addLayout(row);
    connect(add, &QPushButton::clicked, this, &StartPage::addLinkRequested);
    connect(recording, &QPushButton::clicked, this, &StartPage::openRecordingRequested);
    buildStories(*m_column, *main);
    m_column->addStretch(1);
    return main;
}

void StartPage::buildStories(QBoxLayout &column, QWidget &parent)
{
    auto *head = new QHBoxLayout;
    auto *title = new ElidedLabel(tr("Try with a simulated motor"), &parent);
    setTextRole(*title, TextRole::Title);
    auto *bench = linkButton(tr("Open the simulated bench"), &parent);
    bench->setToolTip(tr("Controllers of every family with real bus timing; nothing real can move."));
    head->addWidget(title, 1);
    head->addWidget(bench);
    column.addLayout(head);
    connect(bench, &QPushButton::clicked, this, &StartPage::benchWanted);
    m_storyGrid = new QGridLayout;
    m_storyGrid->setSpacing(m_theme.theme().u(12));
    for (const Story &story : stories()) {
        auto *card = new StoryCard(story, m_theme, &parent);
        card->setPrimary(m_stories.empty());
        connect(card, &StoryCard::wanted, this, &StartPage::storyWanted);
        m_stories.push_back(card);
    }
    column.addLayout(m_storyGrid);
}

QWidget *StartPage::buildSide()
{
    auto *side = new QWidget(this);
    auto *column = layoutIn<QVBoxLayout>(side, m_theme.theme().u(12));
    m_recent = new ListCard(m_theme, tr("Continue"), side);
    m_recent->setObjectName(QStringLiteral("recent"));
    m_firmware = new ListCard(m_theme, tr("Firmware on this computer"), side);
    m_firmware->setObjectName(QStringLiteral("firmwareOnDisk"));
    auto *folder = linkButton(tr("Folder…"), m_firmware);
    folder->setToolTip(tr("Choose the folder whose images are listed here"));
    m_firmware->addHeadWidget(folder);
    column->addWidget(m_recent);
    column->addWidget(m_firmware);
    column->addWidget(buildFirst(side));
    column->addStretch(1);
    connect(m_recent, &ListCard::activated, this, &StartPage::recentWanted);
    connect(m_firmware, &ListCard::activated, this, &StartPage::firmwareWanted);
    connect(folder, &QPushButton::clicked, this, &StartPage::firmwareFolderWanted);
    return side;
}

QWidget *StartPage::buildFirst(QWidget *parent)
{
    auto *card = new Card(m_theme, tr("First time here?"), parent);
    card->setAccessibleName(tr("First time here?"));
    card->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred); // as high as its words at this width
    auto *text
        = textLabel(tr("STOP works on key press, everywhere, also while you type (use Esc then). It is software: "
                       "keep a hardware stop in the supply."),
            TextRole::Body, Tone::Dim, card);
    text->setWordWrap(true);
    card->body().addWidget(text);
    auto *row = new QHBoxLayout;
    auto *keys = linkButton(tr("Keys"), card);
    auto *guides = linkButton(tr("Wiring guides"), card);
    row->addWidget(keys);
    row->addWidget(guides);
    row->addStretch();
    card->body().addLayout(row);
    connect(keys, &QPushButton::clicked, this, &StartPage::keysWanted);
    connect(guides, &QPushButton::clicked, this, &StartPage::guidesWanted);
    return card;
}

void StartPage::follow()
{
    m_doctor->follow();
}

void StartPage::setRecent(std::vector<ListCard::Row> rows)
{
    m_recent->setRows(std::move(rows), tr("Sessions and recordings that you have opened stand here."));
}

void StartPage::setFirmware(std::vector<ListCard::Row> rows)
{
    m_firmware->setRows(std::move(rows), tr("No image (.hex) in this folder."));
}

/// The side column beside the rest where there is room; as many stories in a row as none of them is cut.
void StartPage::arrange()
{
    const Theme &theme = m_theme.theme();
    const bool beside = width() >= theme.u(roomForSide);
    const auto direction = beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
    if (m_row->direction() != direction)
        m_row->setDirection(direction);
    m_side->setMinimumWidth(beside ? theme.u(sideWidth) : 0);
    m_side->setMaximumWidth(beside ? theme.u(sideWidth) : QWIDGETSIZE_MAX);
    const int room = width() - 2 * theme.u(16) - (beside ? theme.u(sideWidth) + theme.u(16) : 0);
    const int gap = theme.u(12);
    const int most = static_cast<int>(m_stories.size());
    const int columns = std::clamp((room + gap) / (theme.u(storyWidth) + gap), 1, most);
    if (std::exchange(m_columns, columns) == columns)
        return;
    for (int i = 0; i < most; ++i) {
        m_storyGrid->addWidget(m_stories[static_cast<std::size_t>(i)], i / columns, i % columns);
        m_storyGrid->setColumnStretch(i, i < columns ? 1 : 0);
    }
}

} // namespace mb
