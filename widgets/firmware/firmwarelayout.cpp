// SPDX-License-Identifier: GPL-3.0-or-later
// How the Firmware page is put together; what it does is in firmwarepage.cpp.
#include "widgets/common/iconbutton.h"
#include "widgets/common/labels.h"
#include "widgets/common/stateglyph.h"
#include "widgets/firmware/firmwarepage.h"
#include "widgets/firmware/pagemap.h"
#include "widgets/firmware/routepanel.h"
#include "widgets/firmware/stepspanel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QProgressBar>
#include <QScrollArea>
#include <QSplitter>
#include <QTableWidget>
#include <QVBoxLayout>

namespace mb {

FirmwarePage::FirmwarePage(Workbench &workbench, Selection &selection, const ThemeSource &theme, QWidget *parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_selection(selection)
    , m_theme(theme)
{
    setObjectName(QStringLiteral("firmwarePage"));
    setAccessibleName(tr("Firmware"));
    setAcceptDrops(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    buildImage(*column);
    m_route = new RoutePanel(theme, this);
    column->addWidget(m_route);
    buildChecks(*column);
    buildProgress(*column);
    buildBody(*column);
    connect(m_route, &RoutePanel::changed, this, &FirmwarePage::follow);
    connect(&workbench, &Workbench::changed, this, &FirmwarePage::follow);
    connect(&theme, &ThemeSource::changed, this, [this] {
        m_shownOperation = {}; // the lines of the log have colours of their own
        follow();
    });
    connect(&selection, &Selection::changed, this, &FirmwarePage::follow);
    inspectImage();
}

void FirmwarePage::buildImage(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(16), theme.u(10), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(24));
    const auto pair = [&](const QString &caption, QLabel *&value) {
        auto *box = new QVBoxLayout;
        box->setSpacing(0);
        box->addWidget(textLabel(caption, TextRole::Caption, Tone::Dim, this));
        value = textLabel({}, TextRole::Emphasis, Tone::Text, this);
        box->addWidget(value);
        row->addLayout(box);
    };
    pair(tr("device"), m_deviceName);
    pair(tr("firmware"), m_versions);
    pair(tr("image"), m_imageName);
    m_imageDetail = new ElidedLabel({}, this);
    row->addWidget(m_imageDetail, 1, Qt::AlignBottom);
    auto *open = new CommandButton(m_theme, Symbol::Folder, tr("Open image…"), this);
    row->addWidget(open);
    column.addLayout(row);
    column.addWidget(separatorLine(Qt::Horizontal, this));
    connect(open, &QPushButton::clicked, this, &FirmwarePage::askImage);
}

void FirmwarePage::buildChecks(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(16), theme.u(10), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(8));
    row->addWidget(new SectionLabel(tr("Before start"), this));
    for (Check &check : m_checks) {
        row->addSpacing(theme.u(8));
        check.glyph = new StateGlyph(m_theme, GlyphState::Waiting, this);
        check.text = textLabel({}, TextRole::Body, Tone::Text, this);
        row->addWidget(check.glyph);
        row->addWidget(check.text);
    }
    row->addStretch();
    column.addLayout(row);
    column.addWidget(separatorLine(Qt::Horizontal, this));
}

void FirmwarePage::buildProgress(QVBoxLayout &column)
{
    const Theme &theme = m_theme.theme();
    auto *row = new QHBoxLayout;
    row->setContentsMargins(theme.u(16), theme.u(10), theme.u(16), theme.u(10));
    row->setSpacing(theme.u(12));
    auto *box = new QVBoxLayout;
    auto *words = new QHBoxLayout;
    m_step = new ElidedLabel({}, this);
    m_step->setAccessibleName(tr("Step"));
    m_rate = textLabel({}, TextRole::Body, Tone::Dim, this);
    words->addWidget(m_step, 1);
    words->addWidget(m_rate);
    m_progress = new QProgressBar(this);
    m_progress->setAccessibleName(tr("Progress of the update"));
    m_progress->setTextVisible(false);
    m_progress->setFixedHeight(theme.u(8));
    box->addLayout(words);
    box->addWidget(m_progress);
    row->addLayout(box, 1);
    m_cancel = new CommandButton(m_theme, Symbol::Close, tr("Cancel"), this);
    m_start = new CommandButton(m_theme, Symbol::Play, tr("Update"), this);
    m_start->setTextVariants({tr("Update"), tr("Run the update again")});
    m_start->setPrimary(true);
    row->addWidget(m_cancel);
    row->addWidget(m_start);
    column.addLayout(row);
    column.addWidget(separatorLine(Qt::Horizontal, this));
    connect(m_start, &QPushButton::clicked, this, &FirmwarePage::startUpdate);
    connect(
        m_cancel, &QPushButton::clicked, this, [this] { m_workbench.send(orders::CancelOperation{m_shownOperation}); });
}

void FirmwarePage::buildBody(QVBoxLayout &column)
{
    auto *split = new QSplitter(Qt::Horizontal, this);
    split->addWidget(buildLog(split));
    split->addWidget(buildSide(split));
    split->setStretchFactor(0, 1);
    split->setSizes({m_theme.theme().u(800), m_theme.theme().u(340)});
    column.addWidget(split, 1);
}

QWidget *FirmwarePage::buildLog(QWidget *parent)
{
    const Theme &theme = m_theme.theme();
    auto *panel = new QWidget(parent);
    auto *column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto *head = new QHBoxLayout;
    head->setContentsMargins(theme.u(16), theme.u(6), theme.u(8), theme.u(6));
    head->addWidget(new SectionLabel(tr("Log"), panel));
    head->addStretch();
    QPushButton *save = linkButton(tr("Save log…"), panel);
    head->addWidget(save);
    column->addLayout(head);
    m_log = new QTableWidget(0, 2, panel);
    m_log->setAccessibleName(tr("Log of the update"));
    m_log->horizontalHeader()->hide();
    m_log->verticalHeader()->hide();
    m_log->verticalHeader()->setDefaultSectionSize(theme.u(22));
    m_log->setColumnWidth(0, theme.u(120));
    m_log->horizontalHeader()->setStretchLastSection(true);
    m_log->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_log->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_log->setShowGrid(false);
    m_log->setFrameShape(QFrame::NoFrame);
    column->addWidget(m_log, 1);
    connect(save, &QPushButton::clicked, this, &FirmwarePage::askSaveLog);
    return panel;
}

QWidget *FirmwarePage::buildSide(QWidget *parent)
{
    const Theme &theme = m_theme.theme();
    auto *scroll = new QScrollArea(parent);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *panel = new QWidget(scroll);
    scroll->setWidget(panel);
    auto *column = new QVBoxLayout(panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.u(8));
    auto *safety = new QFrame(panel);
    m_safety = safety;
    auto *words = new QVBoxLayout(safety);
    words->setContentsMargins(theme.u(16), theme.u(12), theme.u(16), theme.u(12));
    words->setSpacing(theme.u(2));
    m_safetyTitle = textLabel({}, TextRole::Emphasis, Tone::Ok, safety);
    m_safetyText = textLabel({}, TextRole::Caption, Tone::Dim, safety);
    m_safetyText->setWordWrap(true);
    words->addWidget(m_safetyTitle);
    words->addWidget(m_safetyText);
    column->addWidget(safety);
    auto *inner = new QVBoxLayout;
    inner->setContentsMargins(theme.u(16), 0, theme.u(16), theme.u(12));
    inner->setSpacing(theme.u(8));
    m_steps = new StepsPanel(m_theme, panel);
    inner->addWidget(m_steps);
    m_pagesOfFlash = new QWidget(panel);
    auto *pages = new QVBoxLayout(m_pagesOfFlash);
    pages->setContentsMargins(0, 0, 0, 0);
    pages->setSpacing(theme.u(8));
    pages->addWidget(new SectionLabel(tr("Flash pages"), panel));
    m_map = new PageMap(m_theme, panel);
    pages->addWidget(m_map);
    auto *legend = textLabel(tr("In the order they are written. Green: written. Amber edge: sent again. Dashed: not in "
                                "the image. Red: must not be cut."),
        TextRole::Caption, Tone::Dim, panel);
    legend->setWordWrap(true);
    pages->addWidget(legend);
    inner->addWidget(m_pagesOfFlash);
    m_notes = textLabel({}, TextRole::Caption, Tone::Dim, panel);
    m_notes->setWordWrap(true);
    inner->addWidget(m_notes);
    inner->addStretch();
    column->addLayout(inner, 1);
    return scroll;
}

} // namespace mb
