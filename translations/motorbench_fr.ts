<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AnalysisText</name>
    <message>
        <source>%1: peak %2 at %3 Hz</source>
        <translation>%1&#xa0;: pic %2 à %3 Hz</translation>
    </message>
    <message>
        <source>%1: fewer than 16 samples connect</source>
        <translation>%1&#xa0;: moins de 16 échantillons contigus</translation>
    </message>
    <message>
        <source>the longest stretch without a gap</source>
        <translation>le plus long intervalle sans lacune</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 en fonction de %2</translation>
    </message>
    <message>
        <source>%1 points, every %2. sample</source>
        <translation>%1 points, un échantillon sur %2</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1: peak –</source>
        <translation>%1 : pic –</translation>
    </message>
</context>
<context>
    <name>AxisParameters</name>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
</context>
<context>
    <name>AxisText</name>
    <message>
        <source>Axis %1</source>
        <translation>Axe %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>mode and target</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>DeviceActions</name>
    <message>
        <source>Identify (blink)</source>
        <translation>Identifier (clignoter)</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Assign another number…</source>
        <translation>Attribuer un autre numéro…</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Lire et effacer les défauts</translation>
    </message>
    <message>
        <source>faults read and cleared</source>
        <translation>défauts lus et effacés</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>Arrêter et compter depuis 0</translation>
    </message>
    <message>
        <source>position 0 is here; the motor is off</source>
        <translation>la position 0 est ici&#x202f;; le moteur est coupé</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Copier %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>Name, 1 … 64 characters (some tools show only 28):</source>
        <translation>Nom, 1 … 64 caractères (certains outils n’en montrent que 28)&#xa0;:</translation>
    </message>
    <message>
        <source>renamed to %1</source>
        <translation>renommé en %1</translation>
    </message>
    <message>
        <source>Number of %1</source>
        <translation>Numéro de %1</translation>
    </message>
    <message>
        <source>New number, 1 … %1. %2 is the next free one on this link:</source>
        <translation>Nouveau numéro, 1 … %1. %2 est le prochain libre sur cette liaison&#xa0;:</translation>
    </message>
    <message>
        <source>number %1 is taken on this link; nothing was sent</source>
        <translation>le numéro %1 est déjà pris sur cette liaison&#x202f;; rien n’a été envoyé</translation>
    </message>
    <message>
        <source>answers as number %1 now</source>
        <translation>répond maintenant sous le numéro %1</translation>
    </message>
    <message>
        <source>%1 cannot be opened: a link address has no place for the question mark in it. Rename it.</source>
        <translation>Impossible d’ouvrir %1&#xa0;: l’adresse d’une liaison ne peut pas contenir de point d’interrogation. Renommez le fichier.</translation>
    </message>
    <message>
        <source>blinks</source>
        <translation>clignote</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>%1 of %2 axes move</source>
        <translation>%1 axes sur %2 en mouvement</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 axes</translation>
    </message>
    <message>
        <source>No answer: %1</source>
        <translation>Pas de réponse&#xa0;: %1</translation>
    </message>
    <message>
        <source>The device refused: %1</source>
        <translation>Refusé par l’appareil&#xa0;: %1</translation>
    </message>
    <message>
        <source>Unexpected answer: %1</source>
        <translation>Réponse inattendue&#xa0;: %1</translation>
    </message>
    <message>
        <source>Differs: %1</source>
        <translation>Différence&#xa0;: %1</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>Liaison perdue&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not possible: %1</source>
        <translation>Impossible&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>Non exécuté&#xa0;: %1</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>axe %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>off</source>
        <translation>arrêt</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>tension</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>suivi</translation>
    </message>
    <message>
        <source>profiled position</source>
        <translation>profil de position</translation>
    </message>
    <message>
        <source>profiled velocity</source>
        <translation>profil de vitesse</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>occupé</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>deux appareils, un seul numéro</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>encore sans numéro</translation>
    </message>
    <message>
        <source>bootloader, needs firmware</source>
        <translation>bootloader, firmware requis</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>online</source>
        <translation>en ligne</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>garde un mouvement</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>marche</translation>
    </message>
    <message>
        <source>boot</source>
        <translation>boot</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>Numéro de série %1</translation>
    </message>
    <message>
        <source>Dialect %1</source>
        <translation>Dialecte %1</translation>
    </message>
    <message>
        <source>It keeps a move that was stopped before it began, and would begin it with the next start on its line. A new move replaces it; switching the unit off clears it.</source>
        <translation>Il garde un mouvement arrêté avant d’avoir commencé, et le lancerait au prochain démarrage sur sa ligne. Un nouveau mouvement le remplace&#x202f;; la mise hors tension l’efface.</translation>
    </message>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 kbit/s</source>
        <translation>%1 kbit/s</translation>
    </message>
    <message>
        <source>no faults</source>
        <translation>aucun défaut</translation>
    </message>
</context>
<context>
    <name>DialogText</name>
    <message>
        <source>Signals that a formula may use</source>
        <translation>Signaux utilisables dans une formule</translation>
    </message>
    <message>
        <source>Double click puts the name into the formula</source>
        <translation>Un double-clic insère le nom dans la formule</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>Note à cet instant</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Ajouter une note</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sauvegarder</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Signal dérivé</translation>
    </message>
    <message>
        <source>counts/s², A, …</source>
        <translation>counts/s², A, …</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formule</translation>
    </message>
    <message>
        <source>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · values are in the unit of the device</source>
        <translation>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, secondes) · abs, sqrt, sin, min, max … · valeurs dans l’unité de l’appareil</translation>
    </message>
    <message>
        <source>Add signal</source>
        <translation>Ajouter un signal</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>Exporter les échantillons</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Intervalle</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Partie visible</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>Toute la session</translation>
    </message>
    <message>
        <source>Show the cursors first: L</source>
        <translation>Afficher d’abord les curseurs&#xa0;: L</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signaux</translation>
    </message>
    <message>
        <source>Plotted signals</source>
        <translation>Signaux tracés</translation>
    </message>
    <message>
        <source>All signals of all devices</source>
        <translation>Tous les signaux de tous les appareils</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tableau CSV</translation>
    </message>
    <message>
        <source>MCAP recording</source>
        <translation>Enregistrement MCAP</translation>
    </message>
    <message>
        <source>Both carry units, the devices with their parameters, notes, and how many samples were lost. MCAP opens in PlotJuggler and Foxglove.</source>
        <translation>Les deux contiennent les unités, les appareils avec leurs paramètres, les notes et le nombre d’échantillons perdus. MCAP s’ouvre dans PlotJuggler et Foxglove.</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Choisir le fichier…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>MCAP recording (*.mcap)</source>
        <translation>Enregistrement MCAP (*.mcap)</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>family “%1”</source>
        <translation>famille «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Parameter files (*.json)</source>
        <translation>Fichiers de paramètres (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Choisissez un autre fichier.</translation>
    </message>
    <message>
        <source>Choose a file of this family. Nothing was changed.</source>
        <translation>Choisissez un fichier de cette famille. Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Rien n’a été modifié.</translation>
    </message>
    <message>
        <source>%1 is not a parameter file.</source>
        <translation>%1 n’est pas un fichier de paramètres.</translation>
    </message>
    <message>
        <source>Choose a file that Export… or motorbenchctl get --file wrote.</source>
        <translation>Choisissez un fichier écrit par Exporter… ou motorbenchctl get --file.</translation>
    </message>
    <message>
        <source>%1 is for %2, which is not in this program.</source>
        <translation>%1 est destiné à %2, que ce programme ne connaît pas.</translation>
    </message>
    <message>
        <source>%1 is for %2, %3 is of the family %4.</source>
        <translation>%1 est destiné à %2, %3 est de la famille %4.</translation>
    </message>
</context>
<context>
    <name>FrameFilterParser</name>
    <message>
        <source>&apos;)&apos; has no &apos;(&apos; before it</source>
        <translation>«&#xa0;)&#xa0;» n’est précédé d’aucun «&#xa0;(&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs a term before it</source>
        <translation>«&#xa0;%1&#xa0;» doit être précédé d’un terme</translation>
    </message>
    <message>
        <source>a term is missing after &apos;%1&apos;</source>
        <translation>il manque un terme après «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;(&apos; is not closed: a &apos;)&apos; is missing</source>
        <translation>«&#xa0;(&#xa0;» n’est pas fermé&#xa0;: il manque un «&#xa0;)&#xa0;»</translation>
    </message>
    <message>
        <source>more than %1 brackets and negations inside each other</source>
        <translation>plus de %1 parenthèses et négations imbriquées</translation>
    </message>
</context>
<context>
    <name>FrameTermReader</name>
    <message>
        <source>&apos;%1&apos;: a comparison begins with field., such as field.%1</source>
        <translation>«&#xa0;%1&#xa0;»&#xa0;: une comparaison commence par field., par exemple field.%1</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; has nothing after the colon</source>
        <translation>«&#xa0;%1:&#xa0;» n’est suivi de rien après le deux-points</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; id, family, message, device, dir, data, is and field. are</source>
        <translation>«&#xa0;%1:&#xa0;» est inconnu&#x202f;; connus&#xa0;: id, family, message, device, dir, data, is et field.</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; &apos;%2:&apos; is</source>
        <translation>«&#xa0;%1:&#xa0;» est inconnu&#x202f;; connu&#xa0;: «&#xa0;%2:&#xa0;»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un identifiant&#xa0;: hexadécimal, par exemple 0x2061405, 0x2061* ou 100..1FF</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no device number: such as 5, 5,7 or 1..9</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un numéro d’appareil&#xa0;: par exemple 5, 5,7 ou 1..9</translation>
    </message>
    <message>
        <source>&apos;%1&apos; are no bytes: hexadecimal such as A125*, without blanks</source>
        <translation>«&#xa0;%1&#xa0;» ne sont pas des octets&#xa0;: hexadécimal, par exemple A125*, sans espaces</translation>
    </message>
    <message>
        <source>no family is called &apos;%1&apos;; there is %2</source>
        <translation>aucune famille ne s’appelle «&#xa0;%1&#xa0;»&#x202f;; il y a %2</translation>
    </message>
    <message>
        <source>&apos;dir:%1&apos; is not known; dir:rx and dir:tx are</source>
        <translation>«&#xa0;dir:%1&#xa0;» est inconnu&#x202f;; connus&#xa0;: dir:rx et dir:tx</translation>
    </message>
    <message>
        <source>&apos;is:%1&apos; is not known; tx, rx, extended, standard, remote, error, unknown, known and control are</source>
        <translation>«&#xa0;is:%1&#xa0;» est inconnu&#x202f;; connus&#xa0;: tx, rx, extended, standard, remote, error, unknown, known et control</translation>
    </message>
    <message>
        <source>&apos;field.&apos; needs the name of a field, such as field.trgt&gt;100</source>
        <translation>«&#xa0;field.&#xa0;» demande le nom d’un champ, par exemple field.trgt&gt;100</translation>
    </message>
    <message>
        <source>&apos;field.%1%2&apos; needs a number behind it</source>
        <translation>«&#xa0;field.%1%2&#xa0;» doit être suivi d’un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>identifier, hexadecimal</source>
        <translation>identifiant, hexadécimal</translation>
    </message>
    <message>
        <source>what the decoder says</source>
        <translation>ce que dit le décodeur</translation>
    </message>
    <message>
        <source>a field by its name: its number, % of full scale, or that there is one</source>
        <translation>un champ par son nom&#xa0;: son nombre, % de la pleine échelle, ou sa présence</translation>
    </message>
    <message>
        <source>bytes, hexadecimal</source>
        <translation>octets, hexadécimal</translation>
    </message>
    <message>
        <source>direction; error, remote, extended, standard, unknown, known; makes a motor move</source>
        <translation>sens&#x202f;; error, remote, extended, standard, unknown, known&#x202f;; met un moteur en mouvement</translation>
    </message>
    <message>
        <source>a bare word: part of a message, family or identifier</source>
        <translation>un mot seul&#xa0;: partie d’un message, d’une famille ou d’un identifiant</translation>
    </message>
    <message>
        <source>terms beside each other must all hold</source>
        <translation>les termes juxtaposés doivent tous être vrais</translation>
    </message>
    <message>
        <source>* stands for any characters, ? for one, a comma for or.</source>
        <translation>* remplace des caractères quelconques, ? un seul, une virgule signifie ou.</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>remote</translation>
    </message>
</context>
<context>
    <name>GainText</name>
    <message>
        <source>duty/(A·s)</source>
        <translation>duty/(A·s)</translation>
    </message>
    <message>
        <source>duty·s/A</source>
        <translation>duty·s/A</translation>
    </message>
    <message>
        <source>duty/A</source>
        <translation>duty/A</translation>
    </message>
    <message>
        <source>duty/rad</source>
        <translation>duty/rad</translation>
    </message>
    <message>
        <source>duty/(rad·s)</source>
        <translation>duty/(rad·s)</translation>
    </message>
    <message>
        <source>duty/(rad/s²)</source>
        <translation>duty/(rad/s²)</translation>
    </message>
    <message>
        <source>duty/(rad/s)</source>
        <translation>duty/(rad/s)</translation>
    </message>
    <message>
        <source>count</source>
        <translation>count</translation>
    </message>
    <message>
        <source>throttle × divisor per %1</source>
        <translation>throttle × diviseur par %1</translation>
    </message>
    <message>
        <source>throttle per %1</source>
        <translation>throttle par %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>GapText</name>
    <message>
        <source>gap %1</source>
        <translation>lacune %1</translation>
    </message>
    <message>
        <source>%1 gaps, %2</source>
        <translation>%1 lacunes, %2</translation>
    </message>
</context>
<context>
    <name>HelpTitles</name>
    <message>
        <source>First hour</source>
        <translation>Première heure</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Raccordement</translation>
    </message>
    <message>
        <source>Tuning by itself</source>
        <translation>Réglage automatique</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Maintenance</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recettes</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sécurité</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>Dépannage</translation>
    </message>
    <message>
        <source>Hardware: %1</source>
        <translation>Matériel&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <comment>the name of this language in itself</comment>
        <translation>Français</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of this language, as in the name of its file</comment>
        <translation>fr</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1 × as large as now, %2.</source>
        <translation>%1 × plus grand que maintenant, %2.</translation>
    </message>
    <message>
        <source>%1 × smaller than now, %2.</source>
        <translation>%1 × plus petit que maintenant, %2.</translation>
    </message>
</context>
<context>
    <name>LinkChoices</name>
    <message>
        <source>up</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>bus-off</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>accès refusé</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>absent</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A recording of frames…</source>
        <translation>Un enregistrement de trames…</translation>
    </message>
    <message>
        <source>file</source>
        <translation>fichier</translation>
    </message>
    <message>
        <source>Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.</source>
        <translation>Relit un journal candump ou Vector ASC comme si son bus était ici. Aucun envoi n’est possible.</translation>
    </message>
    <message>
        <source>The whole simulated bench</source>
        <translation>Le banc simulé complet</translation>
    </message>
    <message>
        <source>Simulated CAN bus</source>
        <translation>Bus CAN simulé</translation>
    </message>
    <message>
        <source>Simulated serial line</source>
        <translation>Ligne série simulée</translation>
    </message>
    <message>
        <source>Simulated SPI board</source>
        <translation>Carte SPI simulée</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>Interfaces CAN</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Ports série</translation>
    </message>
    <message>
        <source>SPI devices</source>
        <translation>Périphériques SPI</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Enregistrements</translation>
    </message>
    <message>
        <source>Without hardware</source>
        <translation>Sans matériel</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Port série</translation>
    </message>
    <message>
        <source>SPI device</source>
        <translation>Périphérique SPI</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>Interface CAN</translation>
    </message>
    <message>
        <source>%1, at the real speed of their link.</source>
        <translation>%1, à la vitesse réelle de leur liaison.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Contrôleurs de toutes les familles avec un vrai cadencement de bus&#x202f;; rien de réel ne peut bouger.</translation>
    </message>
</context>
<context>
    <name>MuteUnits</name>
    <message>
        <source>Number of the unit that does not answer, %1 … %2. No other one of its family may answer there: a programmer would not tell them apart.</source>
        <translation>Numéro de l’appareil qui ne répond pas, %1 … %2. Aucun autre de sa famille ne doit y répondre : un programmateur ne saurait pas les distinguer.</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>No link is open whose units a programmer writes</source>
        <translation>Aucune liaison n’est ouverte dont un programmateur écrit les appareils</translation>
    </message>
</context>
<context>
    <name>PlotFeed</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>direct, %1</translation>
    </message>
    <message>
        <source>paused, %1</source>
        <translation>en pause, %1</translation>
    </message>
</context>
<context>
    <name>PlotReadings</name>
    <message>
        <source>t</source>
        <comment>time of both cursors</comment>
        <translation>t</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Δt</source>
        <translation>Δt</translation>
    </message>
    <message>
        <source>1/Δt</source>
        <translation>1/Δt</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Δ %1</source>
        <translation>Δ %1</translation>
    </message>
    <message>
        <source>mean A…B</source>
        <translation>moyenne A…B</translation>
    </message>
    <message>
        <source>min … max</source>
        <translation>min … max</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>σ, %1 samples</source>
        <translation>σ, %1 échantillons</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 à %3</translation>
    </message>
    <message>
        <source>%1 no data</source>
        <translation>%1 sans données</translation>
    </message>
    <message>
        <source>, now %1</source>
        <translation>, maintenant %1</translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation>, 1 lacune</translation>
    </message>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>, %n lacune</numerusform>
            <numerusform>, %n lacunes</numerusform>
        </translation>
    </message>
    <message>
        <source>No traces</source>
        <translation>Aucune courbe</translation>
    </message>
    <message>
        <source>Last %1: %2</source>
        <translation>Dernières %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>PlotStrip</name>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>Cop&amp;ier</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Co&amp;ller</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Tout sélectionner</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
</context>
<context>
    <name>SignalText</name>
    <message>
        <source>small</source>
        <extracomment>Translate as &quot;capital&quot; where a noun has a capital letter in the middle of a line too.</extracomment>
        <translation>small</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>%1 Hz, %2 of %3 lost</source>
        <translation>%1 Hz, %2 sur %3 perdus</translation>
    </message>
</context>
<context>
    <name>Stories</name>
    <message>
        <source>Select</source>
        <translation>Sélectionner</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left. Everything that follows is about it.</source>
        <translation>Cliquez sur %1 dans la liste à gauche. Tout ce qui suit le concerne.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc stops, always.</source>
        <translation>Maintenez le bouton Armer en haut, SÛR, pendant une seconde (ou Ctrl+Maj+F12). Rien ne bouge avant. Esc arrête, toujours.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Régler</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Mémoriser</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left.</source>
        <translation>Cliquez sur %1 dans la liste à gauche.</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limiter</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>Maintenez le bouton Armer en haut pendant une seconde (ou Ctrl+Maj+F12).</translation>
    </message>
    <message>
        <source>%1 overshoots: tame it in a minute</source>
        <translation>%1 dépasse&#xa0;: domptez-le en une minute</translation>
    </message>
    <message>
        <source>velocity, set-point dashed</source>
        <translation>vitesse, consigne en tirets</translation>
    </message>
    <message>
        <source>%1 has no current limit: set one that saves it</source>
        <translation>%1 n’a pas de limite de courant&#xa0;: fixez-en une qui le protège</translation>
    </message>
    <message>
        <source>current, limit dashed</source>
        <translation>courant, limite en tirets</translation>
    </message>
    <message>
        <source>Press %2: the motor steps to a speed and back, and the overshoot is measured.</source>
        <translation>Appuyez sur %2 : le moteur fait un échelon de vitesse et revient, et le dépassement est mesuré.</translation>
    </message>
    <message>
        <source>Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at most.</source>
        <translation>Appuyez sur %2 dans la page Conception : le programme trouve des gains et les vérifie. Dompté : un échelon dépasse de 5 % au plus.</translation>
    </message>
    <message>
        <source>Press %2 on the page Tune: the peak current of the step stands in its table.</source>
        <translation>Appuyez sur %2 dans la page Réglage : le courant de pointe de l’échelon figure dans son tableau.</translation>
    </message>
    <message>
        <source>the button</source>
        <translation>le bouton</translation>
    </message>
    <message>
        <source>Arrive</source>
        <translation>Arriver</translation>
    </message>
    <message>
        <source>What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes it, and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target.</source>
        <translation>Ce que P tire des derniers incréments est moindre que le frottement. Entrez parmi les gains %5 (un P plus raide le vainc, davantage de D l’empêche d’osciller) et appuyez de nouveau sur %2 : il s’arrête à 5 incréments de sa cible au plus.</translation>
    </message>
    <message>
        <source>%1 stops short: make it arrive</source>
        <translation>%1 s’arrête avant la cible : faites-le arriver</translation>
    </message>
    <message>
        <source>This one stops about %4 counts short and stays there. Make it arrive.</source>
        <translation>Celui-ci s’arrête environ %4 incréments avant la cible et y reste. Faites-le arriver.</translation>
    </message>
    <message>
        <source>position, set-point dashed</source>
        <translation>position, consigne en tirets</translation>
    </message>
    <message>
        <source>On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>Dans la page Réglage, choisissez Position : ce qui est armé l’est pour un seul mode. Maintenez ensuite le bouton Armer en haut pendant une seconde (ou Ctrl+Maj+F12).</translation>
    </message>
    <message>
        <source>Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts short.</source>
        <translation>Entrez %3 comme cible (derrière ▸) et appuyez sur %2 : le moteur y va et revient, et s’arrête environ %4 incréments avant.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.</source>
        <translation>%6Appuyez sur « Mémoriser et vérifier » à la page Paramètres : terminé lorsque l’appareil prouve que sa flash contient les gains.</translation>
    </message>
    <message>
        <source>On the page Parameters switch the current limit on (search: %7), set it to what the motor may have, and write.</source>
        <translation>Dans la page Paramètres, activez la limite de courant (cherchez&#xa0;: %7), réglez-la à ce que le moteur peut supporter, et écrivez.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters.</source>
        <translation>%6Appuyez sur « Mémoriser et vérifier » à la page Paramètres.</translation>
    </message>
    <message>
        <source>With these gains it goes too far. Find some with which it does not.</source>
        <translation>Avec ces gains, il va trop loin. Trouvez-en avec lesquels ce n’est pas le cas.</translation>
    </message>
    <message>
        <source>Stalled, it draws all that its supply gives, and nothing holds it back. Limit it.</source>
        <translation>Bloqué, il tire tout ce que donne l’alimentation, et rien ne le retient. Limitez-le.</translation>
    </message>
    <message>
        <source>It stores by itself %1 s after its last change: wait for that.</source>
        <translation>Il mémorise de lui-même %1 s après sa dernière modification : attendez-le.</translation>
    </message>
</context>
<context>
    <name>TriggerText</name>
    <message>
        <source>trigger armed, waiting</source>
        <translation>déclencheur armé, en attente</translation>
    </message>
    <message>
        <source>single event caught</source>
        <translation>événement unique capturé</translation>
    </message>
    <message>
        <source>event %1, filling</source>
        <translation>événement %1, remplissage</translation>
    </message>
    <message>
        <source>event %1, waiting for the next</source>
        <translation>événement %1, attente du suivant</translation>
    </message>
</context>
<context>
    <name>TypedFrameText</name>
    <message>
        <source>&apos;%1&apos; is no frame such as 02061405#8125</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une trame telle que 02061405#8125</translation>
    </message>
    <message>
        <source>The identifier is hexadecimal, such as 7FF or 02061405</source>
        <translation>L’identifiant est hexadécimal, par exemple 7FF ou 02061405</translation>
    </message>
    <message>
        <source>%1 has more than 29 bits: at most 1FFFFFFF</source>
        <translation>%1 dépasse 29 bits&#xa0;: 1FFFFFFF au plus</translation>
    </message>
    <message>
        <source>%1 has more than 11 bits: choose 29 bits</source>
        <translation>%1 dépasse 11 bits&#xa0;: choisissez 29 bits</translation>
    </message>
    <message>
        <source>The data are pairs of hexadecimal digits, such as 81 25 11</source>
        <translation>Les données sont des paires de chiffres hexadécimaux, par exemple 81 25 11</translation>
    </message>
    <message>
        <source>%1 bytes: a frame has at most 8</source>
        <translation>%1 octets&#xa0;: une trame en a 8 au plus</translation>
    </message>
</context>
<context>
    <name>UnitText</name>
    <message>
        <source>rpm</source>
        <translation>tr/min</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>UpdateText</name>
    <message>
        <source>a device that is gone</source>
        <translation>un appareil disparu</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Enter %1.</source>
        <translation>Saisissez %1.</translation>
    </message>
    <message>
        <source>Enter %1, or a percentage such as %2.</source>
        <translation>Saisissez %1, ou un pourcentage tel que %2.</translation>
    </message>
    <message>
        <source>%1 is above %2.</source>
        <translation>%1 est supérieur à %2.</translation>
    </message>
    <message>
        <source>%1 is below %2.</source>
        <translation>%1 est inférieur à %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 n’est pas un nombre entier.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Il manque un nombre.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>off or on</source>
        <translation>arrêt ou marche</translation>
    </message>
</context>
<context>
    <name>drawings</name>
    <message>
        <source>3.3 V only</source>
        <translation>3,3 V seulement</translation>
    </message>
    <message>
        <source>57 600 or 115 200 bit/s</source>
        <translation>57 600 ou 115 200 bit/s</translation>
    </message>
    <message>
        <source>60 A, 100 A for 2 s</source>
        <translation>60 A, 100 A pendant 2 s</translation>
    </message>
    <message>
        <source>A, B, index</source>
        <translation>A, B, index</translation>
    </message>
    <message>
        <source>Battery, 12 V</source>
        <translation>Batterie, 12 V</translation>
    </message>
    <message>
        <source>Breaker</source>
        <translation>Disjoncteur</translation>
    </message>
    <message>
        <source>Bridge and motor</source>
        <translation>Pont et moteur</translation>
    </message>
    <message>
        <source>CAN adapter</source>
        <translation>Adaptateur CAN</translation>
    </message>
    <message>
        <source>CAN high</source>
        <translation>CAN high</translation>
    </message>
    <message>
        <source>CAN low</source>
        <translation>CAN low</translation>
    </message>
    <message>
        <source>Drive, offset 1</source>
        <translation>Variateur, offset 1</translation>
    </message>
    <message>
        <source>Drive, offset 2</source>
        <translation>Variateur, offset 2</translation>
    </message>
    <message>
        <source>Encoder board</source>
        <translation>Carte du codeur</translation>
    </message>
    <message>
        <source>GPIO in</source>
        <translation>entrée GPIO</translation>
    </message>
    <message>
        <source>GPIO out</source>
        <translation>sortie GPIO</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Hôte</translation>
    </message>
    <message>
        <source>J4 closed only for 3.3 V, before power</source>
        <translation>J4 fermé pour 3,3 V seulement, hors tension</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Moteur</translation>
    </message>
    <message>
        <source>Motor supply</source>
        <translation>Alimentation moteur</translation>
    </message>
    <message>
        <source>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 ground</source>
        <translation>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 masse</translation>
    </message>
    <message>
        <source>PA4 current, PA3 heat</source>
        <translation>PA4 courant, PA3 chaleur</translation>
    </message>
    <message>
        <source>Pads for a programmer</source>
        <translation>Pastilles pour un programmateur</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programmateur</translation>
    </message>
    <message>
        <source>STM32F1 or F4</source>
        <translation>STM32F1 ou F4</translation>
    </message>
    <message>
        <source>Supermodified, node 4</source>
        <translation>Supermodified, nœud 4</translation>
    </message>
    <message>
        <source>Supermodified, node 5</source>
        <translation>Supermodified, nœud 5</translation>
    </message>
    <message>
        <source>USB to RS-485</source>
        <translation>USB vers RS-485</translation>
    </message>
    <message>
        <source>a Raspberry Pi, say</source>
        <translation>un Raspberry Pi, p. ex.</translation>
    </message>
    <message>
        <source>and a switch</source>
        <translation>et un interrupteur</translation>
    </message>
    <message>
        <source>closed: bootloader</source>
        <translation>fermé : bootloader</translation>
    </message>
    <message>
        <source>each its own number</source>
        <translation>chacun son numéro</translation>
    </message>
    <message>
        <source>each its own offset</source>
        <translation>chacun son offset</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>masse</translation>
    </message>
    <message>
        <source>ground in common</source>
        <translation>masse commune</translation>
    </message>
    <message>
        <source>ground, 3.3 V</source>
        <translation>masse, 3,3 V</translation>
    </message>
    <message>
        <source>motor, 6 A</source>
        <translation>moteur, 6 A</translation>
    </message>
    <message>
        <source>number 1 … 63</source>
        <translation>numéro 1 … 63</translation>
    </message>
    <message>
        <source>on the computer</source>
        <translation>sur l’ordinateur</translation>
    </message>
    <message>
        <source>one host only</source>
        <translation>un seul hôte</translation>
    </message>
    <message>
        <source>or a supply that</source>
        <translation>ou alimentation qui</translation>
    </message>
    <message>
        <source>own driver</source>
        <translation>étage à part</translation>
    </message>
    <message>
        <source>takes braking</source>
        <translation>absorbe le freinage</translation>
    </message>
    <message>
        <source>transceiver at PA11, PA12</source>
        <translation>transceiver sur PA11, PA12</translation>
    </message>
    <message>
        <source>up to 35 V</source>
        <translation>jusqu’à 35 V</translation>
    </message>
    <message>
        <source>with encoder</source>
        <translation>avec codeur</translation>
    </message>
    <message>
        <source>within reach</source>
        <translation>à portée de main</translation>
    </message>
</context>
<context>
    <name>mb::About</name>
    <message>
        <source>About MotorBench</source>
        <translation>À propos de MotorBench</translation>
    </message>
    <message>
        <source>Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>Règle et entretient les contrôleurs de moteurs à courant continu à balais. Logiciel libre sous licence publique générale GNU (GPL), version 3 ou ultérieure, sans aucune garantie.</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>Versions et licences</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copier les versions</translation>
    </message>
</context>
<context>
    <name>mb::AddLinkDialog</name>
    <message>
        <source>Add a link</source>
        <translation>Ajouter une liaison</translation>
    </message>
    <message>
        <source>Links that can be added</source>
        <translation>Liaisons pouvant être ajoutées</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>open</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>aucune trouvée</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Commande pour un terminal</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Adresse de la liaison</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>L’ouvrir à chaque démarrage</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Choisir le fichier…</translation>
    </message>
</context>
<context>
    <name>mb::AdvicePanel</name>
    <message>
        <source>Why it did that</source>
        <translation>Pourquoi ce comportement</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Met ces valeurs en attente&#x202f;; rien n’est encore écrit.</translation>
    </message>
</context>
<context>
    <name>mb::AdviceText</name>
    <message>
        <source>F·K is %1 with I active: the initial lag is paid back as overshoot.</source>
        <translation>F·K vaut %1 avec I actif&#xa0;: le retard initial se paie en dépassement.</translation>
    </message>
    <message>
        <source>It stops %1 counts short: P alone does not overcome friction there.</source>
        <translation>Il s’arrête %1 incréments avant&#xa0;: P seul n’y vainc pas le frottement.</translation>
    </message>
    <message>
        <source>A gain has only %1 steps of its integer; it cannot be set finely.</source>
        <translation>Un gain n’a que %1 pas de son entier&#x202f;; il ne peut pas être réglé finement.</translation>
    </message>
    <message>
        <source>One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.</source>
        <translation>Un incrément du capteur fait varier le rapport cyclique de %1 % via D&#x202f;; au-delà de 10 %, ce n’est plus calme.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp takes %1 to full duty, which is slower than this loop.</source>
        <translation>La rampe du variateur met %1 pour atteindre la pleine commande, plus lente que cette boucle.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1: the loop cannot go faster there.</source>
        <translation>Le rapport cyclique est resté en limite pendant %1&#xa0;: la boucle ne peut pas y aller plus vite.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1 while I went on; that is paid back as overshoot.</source>
        <translation>Le rapport cyclique est resté en limite pendant %1 alors que I continuait&#x202f;; cela se paie en dépassement.</translation>
    </message>
    <message>
        <source>The measured velocity is %1 late; the gains are too lively for that.</source>
        <translation>La vitesse mesurée a %1 de retard&#x202f;; les gains sont trop vifs pour cela.</translation>
    </message>
    <message>
        <source>The velocity comes anew every %1 only; a loop cannot be quicker than that.</source>
        <translation>La vitesse n’est renouvelée que tous les %1&#x202f;; une boucle ne peut pas être plus rapide.</translation>
    </message>
    <message>
        <source>It moved late, at %1 % duty: friction holds it until then.</source>
        <translation>Il a bougé tard, à %1 % de rapport cyclique&#xa0;: le frottement le retient jusque-là.</translation>
    </message>
    <message>
        <source>It takes %1 % duty to stay in place: a load pulls one way.</source>
        <translation>Il lui faut %1 % de rapport cyclique pour rester en place&#xa0;: une charge tire dans un sens.</translation>
    </message>
    <message>
        <source>It swings by %1 counts without end: play between motor and load.</source>
        <translation>Il oscille sans fin de %1 incréments&#xa0;: jeu entre moteur et charge.</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>Mettre %1 en attente</translation>
    </message>
</context>
<context>
    <name>mb::AdviserList</name>
    <message>
        <source>staged</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>correct</translation>
    </message>
    <message>
        <source>fixed in the set</source>
        <translation>corrigé dans le jeu</translation>
    </message>
    <message>
        <source>mind it</source>
        <translation>à noter</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>à corriger</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>non lu</translation>
    </message>
    <message>
        <source>This loop has no F that could fight with I.</source>
        <translation>Cette boucle n’a pas de F qui puisse s’opposer à I.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error only I moves the shaft.</source>
        <translation>uS/kp = %1 : sous cette erreur, seul I déplace l’arbre.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error nothing moves the shaft.</source>
        <translation>uS/kp = %1 : sous cette erreur, rien ne déplace l’arbre.</translation>
    </message>
    <message>
        <source>That is over 2 % of the step.</source>
        <translation>C’est plus de 2 % de l’échelon.</translation>
    </message>
    <message>
        <source>The drive&apos;s least output helps.</source>
        <translation>La sortie minimale du variateur aide.</translation>
    </message>
    <message>
        <source>No gain of the set is an integer of its own.</source>
        <translation>Aucun gain du jeu n’est un entier à part.</translation>
    </message>
    <message>
        <source>%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.</source>
        <translation>%1 a %2 pas de son entier, il en faut au moins %3 : un pas vaut %4 %.</translation>
    </message>
    <message>
        <source>This drive has no ramp of its own.</source>
        <translation>Ce variateur n’a pas de rampe propre.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp was not read yet.</source>
        <translation>La rampe du variateur n’a pas encore été lue.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp is off.</source>
        <translation>La rampe du variateur est désactivée.</translation>
    </message>
    <message>
        <source>Full duty takes %1, over τc/2 = %2: it acts as lag.</source>
        <translation>La pleine commande met %1, plus que τc/2 = %2 : elle agit comme un retard.</translation>
    </message>
    <message>
        <source>Full duty takes %1, under τc/2 = %2.</source>
        <translation>La pleine commande met %1, moins que τc/2 = %2.</translation>
    </message>
    <message>
        <source>F–I conflict</source>
        <translation>Conflit F–I</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Bande morte</translation>
    </message>
    <message>
        <source>D noise</source>
        <translation>Bruit de D</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>D is 0: one count moves no duty.</source>
        <translation>D vaut 0 : un incrément ne change pas le rapport cyclique.</translation>
    </message>
    <message>
        <source>One count moves the duty by %1 % through D; %2 % is the most that is quiet.</source>
        <translation>Un incrément fait varier le rapport cyclique de %1 % via D ; au-delà de %2 %, ce n’est plus calme.</translation>
    </message>
    <message>
        <source>Advisers</source>
        <translation>Conseillers</translation>
    </message>
    <message>
        <source>for %1, slot %2</source>
        <translation>pour %1, jeu %2</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>pour %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Met ces valeurs en attente&#x202f;; rien n’est encore écrit.</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Mettre en attente</translation>
    </message>
    <message>
        <source>F and I in force give back %1 of the step as overshoot. The set has no F.</source>
        <translation>F et I en vigueur rendent %1 de l’échelon en dépassement. Le jeu n’a pas de F.</translation>
    </message>
    <message>
        <source>F and I give back %1 of the step as overshoot.</source>
        <translation>F et I rendent %1 de l’échelon en dépassement.</translation>
    </message>
    <message>
        <source>F and I give nothing back as overshoot.</source>
        <translation>F et I ne rendent rien en dépassement.</translation>
    </message>
</context>
<context>
    <name>mb::AgainstView</name>
    <message>
        <source>plot written to %1</source>
        <translation>courbe écrite dans %1</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <source>One signal against another</source>
        <translation>Un signal en fonction d’un autre</translation>
    </message>
    <message>
        <source>Signal across</source>
        <translation>Signal en abscisse</translation>
    </message>
    <message>
        <source>Signal upwards</source>
        <translation>Signal en ordonnée</translation>
    </message>
    <message>
        <source>against</source>
        <translation>en fonction de</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>A … B: </source>
        <translation>A … B&#xa0;: </translation>
    </message>
    <message>
        <source>what is seen: </source>
        <translation>partie visible&#xa0;: </translation>
    </message>
</context>
<context>
    <name>mb::Arming</name>
    <message>
        <source>%1: cut its power</source>
        <translation>%1&#xa0;: couper l’alimentation</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>expérience</translation>
    </message>
    <message>
        <source>until it is seen</source>
        <translation>jusqu’à ce qu’il soit vu</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>rien à armer</translation>
    </message>
    <message>
        <source>arming off while busy</source>
        <translation>armement bloqué pendant une tâche</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 ne peut pas être armé</translation>
    </message>
    <message>
        <source>not sent to %1</source>
        <translation>non envoyé à %1</translation>
    </message>
    <message>
        <source>it is not heard</source>
        <translation>il ne se fait pas entendre</translation>
    </message>
    <message>
        <source>%1 may still turn</source>
        <translation>%1 tourne peut-être encore</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>non armé&#xa0;: %1</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>armé</translation>
    </message>
    <message>
        <source>%1 guard, %2</source>
        <comment>guard and what tripped it</comment>
        <translation>surveillance %1, %2</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP&#xa0;: %1</translation>
    </message>
    <message>
        <source>STOP: %1; not sent to %2</source>
        <translation>STOP&#xa0;: %1&#x202f;; non envoyé à %2</translation>
    </message>
    <message>
        <source>this window did not respond for %1 s</source>
        <translation>cette fenêtre n’a pas répondu pendant %1 s</translation>
    </message>
    <message>
        <source>disarmed after %1 min without motion</source>
        <translation>désarmé après %1 min sans mouvement</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>l’appareil a disparu</translation>
    </message>
    <message>
        <source>it has restarted</source>
        <translation>il a redémarré</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>un essai avec lui n’est pas encore terminé</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>l&apos;ordinateur était en veille</translation>
    </message>
</context>
<context>
    <name>mb::AxesPanel</name>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>together</source>
        <translation>ensemble</translation>
    </message>
    <message>
        <source>All axes run together</source>
        <translation>Tous les axes tournent ensemble</translation>
    </message>
    <message>
        <source>Run starts every ticked axis at the same moment, each with its own mode and set-point.</source>
        <translation>Lancer démarre tous les axes cochés au même instant, chacun avec son mode et sa consigne.</translation>
    </message>
    <message>
        <source>Copy gains from…</source>
        <translation>Copier les gains de…</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one.</source>
        <translation>Met en attente pour cet axe les gains et limites d’un autre axe.</translation>
    </message>
    <message>
        <source>Same set-point for all ticked</source>
        <translation>Même consigne pour tous les cochés</translation>
    </message>
    <message>
        <source>Mode and set-point of this axis for every ticked one; a position becomes the same distance.</source>
        <translation>Mode et consigne de cet axe pour tous ceux qui sont cochés&#x202f;; une position devient la même distance.</translation>
    </message>
    <message>
        <source>Shows this axis: its mode, set-point, gains, limits and traces</source>
        <translation>Affiche cet axe&#xa0;: son mode, sa consigne, ses gains, ses limites et ses courbes</translation>
    </message>
    <message>
        <source>Axis %1 runs together with the others</source>
        <translation>L’axe %1 tourne avec les autres</translation>
    </message>
    <message>
        <source>Run always moves the axis that is shown.</source>
        <translation>Lancer met toujours en mouvement l’axe affiché.</translation>
    </message>
    <message>
        <source>Run moves this axis, too, at the same moment.</source>
        <translation>Lancer met aussi cet axe en mouvement, au même instant.</translation>
    </message>
</context>
<context>
    <name>mb::AxisCells</name>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Shows this axis in Parameters, Tune and Plots</source>
        <translation>Affiche cet axe dans Paramètres, Réglage et Courbes</translation>
    </message>
</context>
<context>
    <name>mb::AxisChoice</name>
    <message>
        <source>Which axis</source>
        <translation>Quel axe</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>Tous les axes</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>Copier de</translation>
    </message>
    <message>
        <source>Copy gains and limits from another axis</source>
        <translation>Copier les gains et limites d’un autre axe</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one; Write sends them.</source>
        <translation>Met en attente pour cet axe les gains et limites d’un autre&#x202f;; Écrire les envoie.</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Gains et limites de l’axe %1</translation>
    </message>
</context>
<context>
    <name>mb::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message>
        <source>1 more notice</source>
        <translation>1 autre notification</translation>
    </message>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>%n autre notification</numerusform>
            <numerusform>%n autres notifications</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BatteryDialog</name>
    <message>
        <source>Battery of steps</source>
        <translation>Série d’échelons</translation>
    </message>
    <message>
        <source>Run the battery</source>
        <translation>Lancer la série</translation>
    </message>
    <message>
        <source>Steps of the battery and the worst of each metric</source>
        <translation>Échelons de la série et pire valeur de chaque indicateur</translation>
    </message>
    <message>
        <source>Responses of the battery over each other</source>
        <translation>Réponses de la série superposées</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>share of the step</source>
        <translation>fraction de l’échelon</translation>
    </message>
    <message>
        <source>Step, %1</source>
        <translation>Échelon, %1</translation>
    </message>
    <message>
        <source>%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps inside the limits of the page.</source>
        <translation>%1 échelons, alternativement dans les deux sens, de %2 à %3 %4, avec les gains en vigueur. Le moteur tourne&#x202f;; chaque échelon reste dans les limites de la page.</translation>
    </message>
    <message>
        <source>Step %1 of %2: to %3 %4. STOP ends it.</source>
        <translation>Échelon %1 sur %2&#xa0;: vers %3 %4. STOP y met fin.</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Terminé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Ended by: %1</source>
        <translation>Terminé par&#xa0;: %1</translation>
    </message>
    <message>
        <source>Done: %1 trials in the notebook.</source>
        <translation>Terminé&#xa0;: %1 essais dans le carnet.</translation>
    </message>
    <message>
        <source>Ended before all steps were run.</source>
        <translation>Terminé avant que tous les échelons aient été exécutés.</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>pire</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DÉMO</translation>
    </message>
    <message>
        <source>Arm the device first: hold the Arm button for 1 s.</source>
        <translation>Armez d’abord l’appareil&#xa0;: maintenez le bouton Armer pendant 1 s.</translation>
    </message>
    <message>
        <source>Responses over each other</source>
        <translation>Réponses superposées</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>en avant</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>en arrière</translation>
    </message>
    <message>
        <source>Not run: %1</source>
        <translation>Non exécuté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not started, the page has changed: %1</source>
        <translation>Non démarré, la page a changé : %1</translation>
    </message>
</context>
<context>
    <name>mb::BenchText</name>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>%1 au plus</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>paramètres</translation>
    </message>
    <message>
        <source>%1 equal</source>
        <translation>%1 égaux</translation>
    </message>
    <message>
        <source>unusual, %1</source>
        <translation>inhabituel, %1</translation>
    </message>
    <message>
        <source>Connect a unit</source>
        <translation>Raccorder un appareil</translation>
    </message>
    <message>
        <source>It starts by itself when it answers on %1.</source>
        <translation>Démarre tout seul dès qu’il répond sur %1.</translation>
    </message>
    <message>
        <source>Open a recipe, then Start</source>
        <translation>Ouvrir une recette, puis Démarrer</translation>
    </message>
    <message>
        <source>The motor turns in a moment</source>
        <translation>Le moteur va tourner</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Débranchement autorisé</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>Ne pas débrancher</translation>
    </message>
    <message>
        <source>Unplug, connect next</source>
        <translation>Débrancher, raccorder le suivant</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>speed at most %1 counts/s</source>
        <translation>vitesse %1 counts/s au plus</translation>
    </message>
    <message>
        <source>travel at most %1 counts</source>
        <translation>course %1 counts au plus</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>running</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>Hold Arm to go on</source>
        <translation>Maintenir Armer pour continuer</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>duty at most %1 %</source>
        <translation>rapport cyclique %1 % au plus</translation>
    </message>
    <message>
        <source>was there already</source>
        <translation>y était déjà</translation>
    </message>
    <message>
        <source>it answers with it</source>
        <translation>répond avec</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>relus</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>sauvegarde</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservée</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>avant la première écriture</translation>
    </message>
    <message>
        <source>Start serves the next unit.</source>
        <translation>Démarrer traite l’appareil suivant.</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>écrit, non prouvé</translation>
    </message>
    <message>
        <source>%1 tests again · %2 sets it aside</source>
        <translation>%1 reteste · %2 met de côté</translation>
    </message>
    <message>
        <source>Paused: no unit starts before the queue goes on.</source>
        <translation>En pause : aucun appareil ne démarre avant la reprise de la file.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>Start serves it once more</source>
        <translation>Démarrer le traite encore une fois</translation>
    </message>
    <message>
        <source>No number was written to it this time.</source>
        <translation>Cette fois, aucun numéro n’y a été écrit.</translation>
    </message>
</context>
<context>
    <name>mb::BodePlot</name>
    <message>
        <source>Magnitude of loop and motor</source>
        <translation>Module de la boucle et du moteur</translation>
    </message>
    <message>
        <source>Phase of loop and motor</source>
        <translation>Phase de la boucle et du moteur</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>magnitude, dB</source>
        <translation>module, dB</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>phase, °</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>boucle</translation>
    </message>
    <message>
        <source>motor ÷ gain</source>
        <translation>moteur ÷ gain</translation>
    </message>
    <message>
        <source>motor ÷ gain, measured</source>
        <translation>moteur ÷ gain, mesuré</translation>
    </message>
    <message>
        <source>0.90 … 0.97</source>
        <translation>0,90 … 0,97</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>non utilisé</translation>
    </message>
    <message>
        <source>measured, γ² ≥ 0.97</source>
        <translation>mesuré, γ² ≥ 0,97</translation>
    </message>
    <message>
        <source>under 0.90, not used</source>
        <translation>sous 0,90, non utilisé</translation>
    </message>
</context>
<context>
    <name>mb::BodeText</name>
    <message>
        <source>crossover %1 Hz</source>
        <translation>coupure %1 Hz</translation>
    </message>
    <message>
        <source>PM %1° at %2 Hz</source>
        <translation>PM %1° à %2 Hz</translation>
    </message>
    <message>
        <source>GM %1 dB at %2 Hz</source>
        <translation>GM %1 dB à %2 Hz</translation>
    </message>
    <message>
        <source>GM –, beyond what was measured</source>
        <translation>GM –, au-delà du mesuré</translation>
    </message>
    <message>
        <source>usable up to %1 Hz</source>
        <translation>utilisable jusqu’à %1 Hz</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>phase margin %1°</source>
        <translation>marge de phase %1°</translation>
    </message>
    <message>
        <source>gain margin %1 dB</source>
        <translation>marge de gain %1 dB</translation>
    </message>
    <message>
        <source>Ms %1</source>
        <translation>Ms %1</translation>
    </message>
</context>
<context>
    <name>mb::BusBar</name>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Holds the frames still; everything is counted and kept meanwhile</source>
        <translation>Fige les trames&#x202f;; tout reste compté et conservé entre-temps</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Vider la liste</translation>
    </message>
    <message>
        <source>Export frames</source>
        <translation>Exporter les trames</translation>
    </message>
    <message>
        <source>Frames that are shown…</source>
        <translation>Trames affichées…</translation>
    </message>
    <message>
        <source>All frames that are kept…</source>
        <translation>Toutes les trames conservées…</translation>
    </message>
    <message>
        <source>Send frame…</source>
        <translation>Envoyer une trame…</translation>
    </message>
    <message>
        <source>What the expression does</source>
        <translation>Ce que fait l’expression</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrer</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>such as message:STS* device:5 not is:error</source>
        <translation>par exemple message:STS* device:5 not is:error</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>Filtrer les trames</translation>
    </message>
    <message>
        <source>How to write a filter</source>
        <translation>Comment écrire un filtre</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>rx</source>
        <translation>rx</translation>
    </message>
    <message>
        <source>tx</source>
        <translation>tx</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>erreurs</translation>
    </message>
    <message>
        <source>Filter hides what does not match; Find marks what does, Enter goes to the next</source>
        <translation>Filtrer masque ce qui ne correspond pas ; Rechercher marque ce qui correspond, Entrée passe au suivant</translation>
    </message>
</context>
<context>
    <name>mb::BusLoadView</name>
    <message>
        <source>Bus load of the last minute</source>
        <translation>Charge du bus de la dernière minute</translation>
    </message>
    <message>
        <source>now %1 %, peak %2 %</source>
        <translation>maintenant %1 %, pic %2 %</translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>pauses the list, and goes on</source>
        <translation>met la liste en pause, puis la reprend</translation>
    </message>
    <message>
        <source>goes to the filter</source>
        <translation>va au filtre</translation>
    </message>
    <message>
        <source>finds the next one</source>
        <translation>trouve le suivant</translation>
    </message>
    <message>
        <source>finds the one before</source>
        <translation>trouve le précédent</translation>
    </message>
    <message>
        <source>not kept %1</source>
        <translation>non conservées %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 sur %2 affichées</translation>
    </message>
    <message>
        <source>Export all frames</source>
        <translation>Exporter toutes les trames</translation>
    </message>
    <message>
        <source>Export the frames that are shown</source>
        <translation>Exporter les trames affichées</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>Journal candump (*.log)</translation>
    </message>
    <message>
        <source>%1 frames written to %2</source>
        <translation>%1 trames écrites dans %2</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; frames/s %2</source>
        <translation>charge %1 &amp;nbsp; trames/s %2</translation>
    </message>
    <message>
        <source>dropped %1 &amp;nbsp; errors %2</source>
        <translation>rejetées %1 &amp;nbsp; erreurs %2</translation>
    </message>
    <message>
        <source>No link yet</source>
        <translation>Pas encore de liaison</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; what passes on it appears here.</source>
        <translation>Ouvrez une liaison, ou le banc simulé depuis le menu&#x202f;; ce qui y passe apparaît ici.</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 n’est pas ouvert</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; bytes/s %2</source>
        <translation>charge %1 &amp;nbsp; octets/s %2</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>enregistre, ou termine l’enregistrement</translation>
    </message>
</context>
<context>
    <name>mb::BusSide</name>
    <message>
        <source>Bus load, %</source>
        <translation>Charge du bus, %</translation>
    </message>
    <message>
        <source>last 60 s, peak %1 %</source>
        <translation>60 dernières s, pic %1 %</translation>
    </message>
    <message>
        <source>%1 identifiers</source>
        <translation>%1 identifiants</translation>
    </message>
    <message>
        <source>busiest %1, %2 frames/s</source>
        <translation>le plus actif %1, %2 trames/s</translation>
    </message>
    <message>
        <source>%1 frames of identifiers without a row</source>
        <translation>%1 trames d’identifiants sans ligne</translation>
    </message>
    <message>
        <source>%1 frames that no decoder knows</source>
        <translation>%1 trames qu’aucun décodeur ne connaît</translation>
    </message>
    <message>
        <source>error counters TEC %1, REC %2</source>
        <translation>compteurs d’erreurs TEC %1, REC %2</translation>
    </message>
</context>
<context>
    <name>mb::BusTables</name>
    <message>
        <source>Frames</source>
        <translation>Trames</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>Identifiants</translation>
    </message>
</context>
<context>
    <name>mb::ByteStrip</name>
    <message>
        <source>Bytes %1</source>
        <translation>Octets %1</translation>
    </message>
</context>
<context>
    <name>mb::ChangeRow</name>
    <message>
        <source>fix first</source>
        <translation>à corriger d’abord</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>à revoir</translation>
    </message>
    <message>
        <source>Write %1: %2 to %3</source>
        <translation>Écrire %1&#xa0;: %2 à %3</translation>
    </message>
    <message>
        <source>later</source>
        <translation>plus tard</translation>
    </message>
    <message>
        <source>Written as number %1</source>
        <translation>Écrit en position %1</translation>
    </message>
    <message>
        <source>Stays staged</source>
        <translation>Reste en attente</translation>
    </message>
</context>
<context>
    <name>mb::ChangesPanel</name>
    <message>
        <source>Changes to write</source>
        <translation>À écrire</translation>
    </message>
    <message>
        <source>order is chosen for you</source>
        <translation>ordre choisi pour vous</translation>
    </message>
    <message>
        <source>Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I.</source>
        <translation>D’abord les limites, puis ce qui calme la boucle, puis ce qui la rend plus vive&#xa0;: amortissement avant P, P avant I.</translation>
    </message>
    <message>
        <source>Staged changes</source>
        <translation>Modifications en attente</translation>
    </message>
    <message>
        <source>Nothing is staged. Edit a value in the table, or import a file.</source>
        <translation>Rien en attente. Modifiez une valeur dans le tableau, ou importez un fichier.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Écrire</translation>
    </message>
    <message>
        <source>Each value is written, read back and compared.</source>
        <translation>Chaque valeur est écrite, relue et comparée.</translation>
    </message>
    <message>
        <source>Each value is written. None can be read back: what stands here then is assumed.</source>
        <translation>Chaque valeur est écrite. Aucune ne peut être relue&#xa0;: ce qui figure alors ici est supposé.</translation>
    </message>
    <message>
        <source>Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.</source>
        <translation>Chaque valeur est écrite. %1 sur %2 ne peuvent pas être relues et sont alors supposées&#x202f;; les autres sont comparées.</translation>
    </message>
    <message>
        <source>nothing is staged</source>
        <translation>rien en attente</translation>
    </message>
    <message>
        <source>fix 1 value first</source>
        <translation>corriger d’abord 1 valeur</translation>
    </message>
    <message>
        <source>fix %1 values first</source>
        <translation>corriger d’abord %1 valeurs</translation>
    </message>
    <message>
        <source>look again first</source>
        <translation>à revoir d’abord</translation>
    </message>
    <message>
        <source>none is ticked</source>
        <translation>aucun n’est coché</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>deux appareils, un seul numéro</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>occupé</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 sur %3</translation>
    </message>
    <message>
        <source>The drive stores by itself %1 s after the last change: keep power on.</source>
        <translation>L’appareil mémorise de lui-même %1 s après la dernière modification&#xa0;: laissez-le sous tension.</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Écrire %1</translation>
    </message>
    <message>
        <source>Write the staged changes</source>
        <translation>Écrire les modifications en attente</translation>
    </message>
</context>
<context>
    <name>mb::Closing</name>
    <message>
        <source>Close MotorBench</source>
        <translation>Fermer MotorBench</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>Laisser ouvert</translation>
    </message>
    <message>
        <source>Firmware is being written to %1. Cancel the update?</source>
        <translation>Écriture du firmware dans %1 en cours. Annuler la mise à jour&#x202f;?</translation>
    </message>
    <message>
        <source>What is written now must not be cut: the window closes once it is over.</source>
        <translation>L’écriture en cours ne doit pas être interrompue&#xa0;: la fenêtre se fermera dès qu’elle sera finie.</translation>
    </message>
    <message>
        <source>Cancel the update and close</source>
        <translation>Annuler la mise à jour et fermer</translation>
    </message>
    <message>
        <source>%1 has not been seen to stop. Close anyway?</source>
        <translation>L’arrêt de %1 n’a pas été constaté. Fermer quand même&#x202f;?</translation>
    </message>
    <message>
        <source>It was told to stop. Without this window nobody sees whether it does.</source>
        <translation>L’ordre d’arrêt a été envoyé. Sans cette fenêtre, personne ne voit s’il est suivi.</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Fermer quand même</translation>
    </message>
    <message>
        <source>Units are being served. Cancel the queue?</source>
        <translation>Des appareils sont en cours de traitement. Annuler la file&#xa0;?</translation>
    </message>
    <message>
        <source>The journal knows where it stood, and the queue can be gone on with.</source>
        <translation>Le registre sait où elle en était, et la file peut être reprise.</translation>
    </message>
    <message>
        <source>Cancel the queue and close</source>
        <translation>Annuler la file et fermer</translation>
    </message>
    <message>
        <source>Samples are being written to %1. Cancel the export?</source>
        <translation>Écriture des échantillons dans %1 en cours. Annuler l’export&#x202f;?</translation>
    </message>
    <message>
        <source>Nothing of it is kept then.</source>
        <translation>Il n’en reste alors rien.</translation>
    </message>
    <message>
        <source>Cancel the export and close</source>
        <translation>Annuler l’export et fermer</translation>
    </message>
    <message>
        <source>The window closes once this has ended: %1</source>
        <translation>La fenêtre se ferme dès que ceci est terminé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Tapez ce que vous voulez faire</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: command</comment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>No command begins so</source>
        <translation>Aucune commande ne commence ainsi</translation>
    </message>
</context>
<context>
    <name>mb::ComparedText</name>
    <message>
        <source>in force</source>
        <translation>en vigueur</translation>
    </message>
    <message>
        <source>before</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>%1: unstable on this model</source>
        <translation>%1 : instable sur ce modèle</translation>
    </message>
    <message>
        <source>%1: over %2 %, Ms %3</source>
        <translation>%1 : dép. %2 %, Ms %3</translation>
    </message>
</context>
<context>
    <name>mb::ComparisonBox</name>
    <message>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>état trouvé %1</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>valeurs par défaut</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>un fichier…</translation>
    </message>
</context>
<context>
    <name>mb::Conditions</name>
    <message>
        <source>%1 may still turn: cut its power</source>
        <translation>%1 tourne peut-être encore&#xa0;: coupez son alimentation</translation>
    </message>
    <message>
        <source>Its stop was not confirmed. It is sent again, and first of all when its line is back.</source>
        <translation>Son arrêt n’a pas été confirmé. Il est renvoyé, et en tout premier quand sa ligne est rétablie.</translation>
    </message>
    <message>
        <source>I have looked: it stands</source>
        <translation>J’ai vérifié&#xa0;: il est à l’arrêt</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Arrêté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Maintenez le bouton Armer pendant 1 s pour réarmer.</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 est perdu</translation>
    </message>
    <message>
        <source>Another master drives %1</source>
        <translation>Un autre maître pilote %1</translation>
    </message>
    <message>
        <source>Arming is off until it stops sending control frames.</source>
        <translation>L’armement est bloqué tant qu’il envoie des trames de commande.</translation>
    </message>
    <message>
        <source>Several units answer as %1</source>
        <translation>Plusieurs appareils répondent comme %1</translation>
    </message>
    <message>
        <source>Control is locked. Assign one of them a new number from the menu of its row.</source>
        <translation>Commande verrouillée. Attribuez un nouveau numéro à l’un d’eux dans le menu de sa ligne.</translation>
    </message>
    <message>
        <source>Firmware is being written to %1</source>
        <translation>Écriture du firmware dans %1</translation>
    </message>
    <message>
        <source>Do not unplug. %1 of %2.</source>
        <translation>Ne pas débrancher. %1 sur %2.</translation>
    </message>
    <message>
        <source>Writing the settings of %1 again: %2 of %3</source>
        <translation>Réécriture des réglages de %1&#xa0;: %2 sur %3</translation>
    </message>
    <message>
        <source>Each is confirmed by the board.</source>
        <translation>Chacun est confirmé par la carte.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 was reset: 1 setting is unknown</source>
        <translation>%1 a redémarré&#xa0;: 1 réglage est inconnu</translation>
    </message>
    <message>
        <source>%1 was reset: %2 settings are unknown</source>
        <translation>%1 a redémarré&#xa0;: %2 réglages sont inconnus</translation>
    </message>
    <message>
        <source>The board keeps nothing without power. This program knows what was last written.</source>
        <translation>La carte ne garde rien hors tension. Ce programme connaît les dernières valeurs écrites.</translation>
    </message>
    <message>
        <source>Write them again</source>
        <translation>Réécrire</translation>
    </message>
    <message>
        <source>Trial #%1 on %2 was cut before it put its gains back</source>
        <translation>L’essai n° %1 sur %2 a été interrompu avant de rétablir ses gains</translation>
    </message>
    <message>
        <source>Before it: %1. The motor must stand.</source>
        <translation>Avant&#xa0;: %1. Le moteur doit être à l’arrêt.</translation>
    </message>
    <message>
        <source>Put them back</source>
        <translation>Les rétablir</translation>
    </message>
    <message>
        <source>Writing was cancelled; what is missing can be written later.</source>
        <translation>Écriture annulée&#x202f;; ce qui manque pourra être écrit plus tard.</translation>
    </message>
    <message>
        <source>%1 may have been reset: 1 setting is unknown</source>
        <translation>%1 a peut-être redémarré&#xa0;: 1 réglage est inconnu</translation>
    </message>
    <message>
        <source>%1 may have been reset: %2 settings are unknown</source>
        <translation>%1 a peut-être redémarré&#xa0;: %2 réglages sont inconnus</translation>
    </message>
    <message>
        <source>Nothing shows that it still has what was not saved. This program knows what was last written.</source>
        <translation>Rien ne montre qu’il a encore ce qui n’était pas mémorisé. Ce programme sait ce qui a été écrit en dernier.</translation>
    </message>
    <message>
        <source>Safe to unplug: the update can be run again. %1 of %2.</source>
        <translation>Débranchement autorisé : la mise à jour peut être relancée. %1 sur %2.</translation>
    </message>
    <message>
        <source>Keep what it has</source>
        <translation>Garder ce qu’il a</translation>
    </message>
</context>
<context>
    <name>mb::CountTiles</name>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>refusés avant le départ</translation>
    </message>
    <message>
        <source>mean time</source>
        <translation>durée moyenne</translation>
    </message>
    <message>
        <source>units an hour</source>
        <translation>unités par heure</translation>
    </message>
</context>
<context>
    <name>mb::CrashNotice</name>
    <message>
        <source>The program ended unexpectedly</source>
        <translation>Le programme s’est terminé de façon inattendue</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Rouvrir</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>Lire le rapport</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Report of the crash</source>
        <translation>Rapport du plantage</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>Fichier du rapport</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
</context>
<context>
    <name>mb::DemoStripe</name>
    <message>
        <source>simulated bench</source>
        <translation>banc simulé</translation>
    </message>
    <message>
        <source>Demo  ·  %1  ·  no real motor is connected</source>
        <translation>Démo  ·  %1  ·  aucun moteur réel n’est raccordé</translation>
    </message>
    <message>
        <source>Replay  ·  %1  ·  shows what was recorded, moves no motor</source>
        <translation>Relecture  ·  %1  ·  montre l’enregistrement, ne fait bouger aucun moteur</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Démo</translation>
    </message>
</context>
<context>
    <name>mb::DesignBook</name>
    <message>
        <source>%1 waits in its bootloader.</source>
        <translation>%1 attend dans son bootloader.</translation>
    </message>
    <message>
        <source>This family has no loop that can be tuned.</source>
        <translation>Cette famille n’a pas de boucle réglable.</translation>
    </message>
</context>
<context>
    <name>mb::DesignCourse</name>
    <message>
        <source>What the adviser proposes</source>
        <translation>Ce que propose le conseiller</translation>
    </message>
</context>
<context>
    <name>mb::DesignFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Partie de la page</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Déroulement</translation>
    </message>
</context>
<context>
    <name>mb::DesignOrders</name>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Jeu de gains</translation>
    </message>
    <message>
        <source>slot 0</source>
        <translation>jeu 0</translation>
    </message>
    <message>
        <source>slot 1</source>
        <translation>jeu 1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifier</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Autoréglage</translation>
    </message>
    <message>
        <source>Write and prove</source>
        <translation>Écrire et vérifier</translation>
    </message>
    <message>
        <source>Identifies, writes the chosen set and proves it, in one go</source>
        <translation>Identifie, écrit le jeu choisi et le vérifie, en une seule fois</translation>
    </message>
</context>
<context>
    <name>mb::DesignPage</name>
    <message>
        <source>writes the chosen set and proves it</source>
        <translation>écrit le jeu choisi et le vérifie</translation>
    </message>
    <message>
        <source>identifies, writes and proves in one go</source>
        <translation>identifie, écrit et vérifie en une seule fois</translation>
    </message>
    <message>
        <source>identifies the motor</source>
        <translation>identifie le moteur</translation>
    </message>
    <message>
        <source>writes a report of what is shown</source>
        <translation>écrit un rapport de ce qui est affiché</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Réglage en cours</translation>
    </message>
    <message>
        <source>STOP ends it; what was changed is put back.</source>
        <translation>STOP y met fin&#x202f;; ce qui a été modifié est rétabli.</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Stop the motion before the motor is tuned.</source>
        <translation>Arrêtez le mouvement avant de régler le moteur.</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Occupé</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Non armé</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Maintenez le bouton Armer pendant 1 s pour armer %1.</translation>
    </message>
    <message>
        <source>No tuning here</source>
        <translation>Pas de réglage ici</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Aucun appareil sélectionné</translation>
    </message>
    <message>
        <source>Choose a controller in the list at the left.</source>
        <translation>Choisissez un contrôleur dans la liste à gauche.</translation>
    </message>
    <message>
        <source>Not by itself</source>
        <translation>Pas automatiquement</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DÉMO</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Aucune limite</translation>
    </message>
    <message>
        <source>%1 will turn both ways.</source>
        <translation>%1 tournera dans les deux sens.</translation>
    </message>
</context>
<context>
    <name>mb::DesignPlots</name>
    <message>
        <source>Step, predicted and measured</source>
        <translation>Échelon, prédit et mesuré</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>What the gains will do appears here, before they are written.</source>
        <translation>L’effet des gains apparaît ici, avant leur écriture.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
</context>
<context>
    <name>mb::DeviceCard</name>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>10 dernières s</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Mettre à jour le firmware</translation>
    </message>
    <message>
        <source>No application runs. Settings, number and name are kept.</source>
        <translation>Aucune application ne tourne. Réglages, numéro et nom sont conservés.</translation>
    </message>
    <message>
        <source>An update makes it whole again. It is safe to power off.</source>
        <translation>Une mise à jour le remet en état. La mise hors tension est sans risque.</translation>
    </message>
    <message>
        <source>boot %1 · no telemetry</source>
        <translation>boot %1 · pas de télémétrie</translation>
    </message>
    <message>
        <source>%1 Hz   lost %2</source>
        <translation>%1 Hz   perdus %2</translation>
    </message>
    <message>
        <source>no watchdog</source>
        <translation>sans chien de garde</translation>
    </message>
    <message>
        <source>It keeps its last set-point if this program dies. A second process beside it, the guardian, stops it then.</source>
        <translation>Il garde sa dernière consigne si ce programme s’arrête. Un second processus, le gardien, l’arrête alors.</translation>
    </message>
</context>
<context>
    <name>mb::DeviceLine</name>
    <message>
        <source>Selected device</source>
        <translation>Appareil sélectionné</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>boîtier</translation>
    </message>
    <message>
        <source>SN %1 · fw %2</source>
        <translation>N/S %1 · fw %2</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>recherche</translation>
    </message>
    <message>
        <source>%1 of %2: %3, now %4
Its pages show this axis; drag it to a plot.</source>
        <translation>%1 sur %2&#xa0;: %3, maintenant %4
Ses pages montrent cet axe&#x202f;; faites-le glisser sur un graphique.</translation>
    </message>
    <message>
        <source>%1
Double click or Enter plots it; drag it to a plot.</source>
        <translation>%1
Double-clic ou Entrée le trace&#x202f;; faites-le glisser sur un graphique.</translation>
    </message>
</context>
<context>
    <name>mb::DeviceTree</name>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Rechercher à nouveau</translation>
    </message>
    <message>
        <source>Filter devices</source>
        <translation>Filtrer les appareils</translation>
    </message>
    <message>
        <source>Hide devices</source>
        <translation>Masquer les appareils</translation>
    </message>
    <message>
        <source>Filter by name, number, serial</source>
        <translation>Nom, numéro, n° de série</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Pas encore d’appareil</translation>
    </message>
    <message>
        <source>Devices appear here by themselves as soon as a link answers.</source>
        <translation>Les appareils apparaissent ici d’eux-mêmes dès qu’une liaison répond.</translation>
    </message>
    <message>
        <source>Links and devices</source>
        <translation>Liaisons et appareils</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Ajouter liaison</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simuler</translation>
    </message>
    <message>
        <source>Open a CAN interface, a serial port or another link</source>
        <translation>Ouvrir une interface CAN, un port série ou une autre liaison</translation>
    </message>
    <message>
        <source>Open the simulated bench; no real motor is connected to it</source>
        <translation>Ouvrir le banc simulé&#x202f;; aucun moteur réel n’y est raccordé</translation>
    </message>
    <message>
        <source>Show 1 new device</source>
        <translation>Afficher 1 nouvel appareil</translation>
    </message>
    <message>
        <source>Show %1 new devices</source>
        <translation>Afficher %1 nouveaux appareils</translation>
    </message>
    <message>
        <source>Search every rate and address (takes minutes)</source>
        <translation>Rechercher sur tous les débits et adresses (prend plusieurs minutes)</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Annuler la recherche</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>Tracer %1</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>L’ouvrir à chaque démarrage</translation>
    </message>
    <message>
        <source>Close this link</source>
        <translation>Fermer cette liaison</translation>
    </message>
</context>
<context>
    <name>mb::DifferenceTable</name>
    <message>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>belongs to one unit, copied only if you tick it</source>
        <translation>propre à un appareil, copié seulement si vous le cochez</translation>
    </message>
    <message>
        <source>assumed: it cannot be read</source>
        <translation>supposé&#xa0;: lecture impossible</translation>
    </message>
    <message>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <source>This unit</source>
        <translation>Cet appareil</translation>
    </message>
    <message>
        <source>%1 of %2 differ</source>
        <translation>%1 sur %2 diffèrent</translation>
    </message>
</context>
<context>
    <name>mb::DoctorCard</name>
    <message>
        <source>Connection doctor</source>
        <translation>Diagnostic de liaison</translation>
    </message>
    <message>
        <source>looks by itself</source>
        <translation>vérifie de lui-même</translation>
    </message>
    <message>
        <source>CAN</source>
        <translation>CAN</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Commande pour un terminal</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Copier la commande</translation>
    </message>
    <message>
        <source>Paste it into a terminal; this program never runs as root</source>
        <translation>Collez-la dans un terminal&#x202f;; ce programme ne s’exécute jamais en root</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconnecter</translation>
    </message>
    <message>
        <source>Open this link now</source>
        <translation>Ouvrir cette liaison maintenant</translation>
    </message>
    <message>
        <source>The command is in the clipboard; paste it into a terminal.</source>
        <translation>La commande est dans le presse-papiers&#x202f;; collez-la dans un terminal.</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>as the device is set</source>
        <translation>réglage de l’appareil</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>freinage</translation>
    </message>
    <message>
        <source>coast</source>
        <translation>roue libre</translation>
    </message>
    <message>
        <source>At zero output</source>
        <translation>À sortie nulle</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>À zéro</translation>
    </message>
    <message>
        <source>Reverse motor</source>
        <translation>Inverser le moteur</translation>
    </message>
    <message>
        <source>Forward output turns the motor the other way. Changing it disarms.</source>
        <translation>La marche avant fait tourner le moteur dans l’autre sens. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Reverse sensor</source>
        <translation>Inverser le capteur</translation>
    </message>
    <message>
        <source>The encoder counts the other way. Changing it disarms.</source>
        <translation>Le codeur compte dans l’autre sens. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Override limits</source>
        <translation>Ignorer les limites</translation>
    </message>
    <message>
        <source>The two below replace the device&apos;s own settings for limit switches. Changing it disarms.</source>
        <translation>Les deux options ci-dessous remplacent les réglages de fins de course de l’appareil. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Forward limit off</source>
        <translation>Limite avant désactivée</translation>
    </message>
    <message>
        <source>The motor runs past the forward limit. Changing it disarms.</source>
        <translation>Le moteur dépasse la limite avant. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Reverse limit off</source>
        <translation>Limite arrière désactivée</translation>
    </message>
    <message>
        <source>The motor runs past the reverse limit. Changing it disarms.</source>
        <translation>Le moteur dépasse la limite arrière. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>Rampe de la sortie, rapport cyclique par seconde</translation>
    </message>
    <message>
        <source>duty/s, 0 = none</source>
        <translation>/s, 0 = aucune</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>ramp %1 duty/s</source>
        <translation>rampe %1/s</translation>
    </message>
    <message>
        <source>motor reversed</source>
        <translation>moteur inversé</translation>
    </message>
    <message>
        <source>sensor reversed</source>
        <translation>capteur inversé</translation>
    </message>
    <message>
        <source>limits overridden</source>
        <translation>limites ignorées</translation>
    </message>
    <message>
        <source>Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>Variation maximale de la sortie en rapport cyclique par seconde : 2 met 0,5 s de 0 à 100 %.</translation>
    </message>
    <message>
        <source>duty/s, 0 = %1</source>
        <translation>/s, 0 = %1</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 or a positive number of duty per second.</source>
        <translation>%1 n’est pas une rampe. Saisissez 0 ou un rapport cyclique par seconde positif.</translation>
    </message>
</context>
<context>
    <name>mb::EntryText</name>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>pas terminé</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>dans son état actuel</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2&#xa0;: %3</translation>
    </message>
</context>
<context>
    <name>mb::EnvelopePanel</name>
    <message>
        <source>Travel ±</source>
        <translation>Course ±</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Rapport cyclique</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Enveloppe</translation>
    </message>
    <message>
        <source>Envelope: %1</source>
        <translation>Enveloppe&#xa0;: %1</translation>
    </message>
    <message>
        <source>Empty: what the device itself says</source>
        <translation>Vide&#xa0;: ce que dit l’appareil lui-même</translation>
    </message>
    <message>
        <source>%1 holds</source>
        <translation>%1 s’applique</translation>
    </message>
    <message>
        <source>not bounded, %1</source>
        <translation>sans borne, %1</translation>
    </message>
    <message>
        <source>%1: %2 is no limit. It is more than 0, and at most %3.</source>
        <translation>%1&#xa0;: %2 n’est pas une limite. Elle est supérieure à 0 et d’au plus %3.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentDialog</name>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>Of which motor</source>
        <translation>De quel moteur</translation>
    </message>
    <message>
        <source>Most power</source>
        <translation>Puissance maximale</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>Non commencé</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>Progression de l’expérience</translation>
    </message>
    <message>
        <source>Log of the experiment</source>
        <translation>Journal de l’expérience</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>STOP, Esc or Cancel ends it at any time.</source>
        <translation>STOP, Esc ou Annuler y met fin à tout moment.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Hold to turn the motor</source>
        <translation>Maintenir pour faire tourner le moteur</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Found and kept for this device.</source>
        <translation>Trouvé et conservé pour cet appareil.</translation>
    </message>
    <message>
        <source>Cancelled. The motor is stopped; gains and limits are as they were.</source>
        <translation>Annulé. Le moteur est arrêté&#x202f;; gains et limites sont inchangés.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentText</name>
    <message>
        <source>at most %1 s</source>
        <translation>%1 s au plus</translation>
    </message>
    <message>
        <source>inside the envelope · %1</source>
        <translation>dans l’enveloppe · %1</translation>
    </message>
    <message>
        <source>inside the envelope · %1 of %2 · %3</source>
        <translation>dans l’enveloppe · %1 sur %2 · %3</translation>
    </message>
    <message>
        <source>This mode has no loop that can be tried; Live drives it.</source>
        <translation>Ce mode n’a pas de boucle à essayer&#x202f;; «&#xa0;Direct&#xa0;» le pilote.</translation>
    </message>
    <message>
        <source>Nothing bounds the motor: enter travel, duty, and what else is empty here.</source>
        <translation>Rien ne borne le moteur&#xa0;: saisissez la course, le rapport cyclique et ce qui est encore vide ici.</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Saisissez où la boucle doit aller.</translation>
    </message>
    <message>
        <source>It is there already; enter another place to go to.</source>
        <translation>Il y est déjà&#x202f;; saisissez une autre destination.</translation>
    </message>
</context>
<context>
    <name>mb::ExportBar</name>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’export</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Writing samples</source>
        <translation>Écriture des échantillons</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Un seul export à la fois&#xa0;: %1 est en cours d’écriture.</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>écriture de %1</translation>
    </message>
    <message>
        <source>%1 written: %2 samples, %3 lost</source>
        <translation>%1 écrit&#xa0;: %2 échantillons, %3 perdus</translation>
    </message>
    <message>
        <source>export cancelled, nothing was written</source>
        <translation>export annulé, rien n’a été écrit</translation>
    </message>
</context>
<context>
    <name>mb::FaultLine</name>
    <message>
        <source>Is that meant?</source>
        <translation>Est-ce voulu&#x202f;?</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>Revenir à %1</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Rétablir</translation>
    </message>
</context>
<context>
    <name>mb::FileExchange</name>
    <message>
        <source>%1 says what the device has.</source>
        <translation>%1 correspond à l’appareil.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>Rien en attente.</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>Import de %1</translation>
    </message>
    <message>
        <source>Nothing is written yet: look through the list, then write.</source>
        <translation>Rien n’est encore écrit&#xa0;: parcourez la liste, puis écrivez.</translation>
    </message>
    <message>
        <source>Left out: %1, for one: %2.</source>
        <translation>Omis&#xa0;: %1, par exemple&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Staged from %1: %2 of its values differ.</source>
        <translation>Mis en attente depuis %1&#xa0;: %2 de ses valeurs diffèrent.</translation>
    </message>
    <message>
        <source>Undo the import</source>
        <translation>Annuler l’import</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Choisissez un autre emplacement.</translation>
    </message>
    <message>
        <source>%1 parameters exported to %2</source>
        <translation>%1 paramètres exportés vers %2</translation>
    </message>
</context>
<context>
    <name>mb::FirmwarePage</name>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>starts the update</source>
        <translation>lance la mise à jour</translation>
    </message>
    <message>
        <source>What is updated</source>
        <translation>Ce qui est mis à jour</translation>
    </message>
    <message>
        <source>Selected unit</source>
        <translation>Appareil sélectionné</translation>
    </message>
    <message>
        <source>Queue of units</source>
        <translation>File d’appareils</translation>
    </message>
    <message>
        <source>Unit that does not answer</source>
        <translation>Appareil qui ne répond pas</translation>
    </message>
    <message>
        <source>A unit whose update was cut may be mute: say where it is, and it can be written again</source>
        <translation>Un appareil dont la mise à jour a été interrompue peut être muet : dites où il est, et il pourra être réécrit</translation>
    </message>
</context>
<context>
    <name>mb::FirmwareShelf</name>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>%1 · checked · %2</source>
        <translation>%1 · vérifié · %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Détails</translation>
    </message>
</context>
<context>
    <name>mb::FrameDetail</name>
    <message>
        <source>Selected frame</source>
        <translation>Trame sélectionnée</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Trame</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Champs</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the selected frames as candump text (Ctrl+C)</source>
        <translation>Copier les trames sélectionnées en texte candump (Ctrl+C)</translation>
    </message>
    <message>
        <source>Send again…</source>
        <translation>Renvoyer…</translation>
    </message>
    <message>
        <source>No frame selected</source>
        <translation>Aucune trame sélectionnée</translation>
    </message>
    <message>
        <source>Select one to see its fields</source>
        <translation>Sélectionnez-en une pour voir ses champs</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Error frame</source>
        <translation>Trame d’erreur</translation>
    </message>
    <message>
        <source>Unknown frame</source>
        <translation>Trame inconnue</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>envoyée</translation>
    </message>
    <message>
        <source>received</source>
        <translation>reçue</translation>
    </message>
    <message>
        <source>%1 · %2 #%3 · %4</source>
        <translation>%1 · %2 #%3 · %4</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 = %2, bits %3</source>
        <translation>%1 = %2, bits %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
</context>
<context>
    <name>mb::FrameModel</name>
    <message>
        <source>err</source>
        <translation>err</translation>
    </message>
    <message>
        <source>tx</source>
        <translation>tx</translation>
    </message>
    <message>
        <source>rx</source>
        <translation>rx</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>trame d’erreur</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>asks for data</source>
        <translation>demande des données</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>aucun décodeur ne connaît cet identifiant</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t, s</translation>
    </message>
    <message>
        <source>Δ ms</source>
        <translation>Δ ms</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>sens</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>message</source>
        <translation>message</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>app.</translation>
    </message>
    <message>
        <source>decoded</source>
        <translation>décodé</translation>
    </message>
    <message>
        <source>data</source>
        <translation>données</translation>
    </message>
</context>
<context>
    <name>mb::GainRow</name>
    <message>
        <source>Use it</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Use this %1</source>
        <translation>Utiliser %1 tel quel</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>Rétablir %1</translation>
    </message>
    <message>
        <source>%1, one decade either way</source>
        <translation>%1, une décade de part et d’autre</translation>
    </message>
    <message>
        <source>One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %</source>
        <translation>Une décade de part et d’autre. ← → 2 %, avec Maj 0,2 %, avec Ctrl 20 %</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>mémorisé</translation>
    </message>
    <message>
        <source>RAM</source>
        <translation>RAM</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatil</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>modifié</translation>
    </message>
    <message>
        <source>range</source>
        <translation>plage</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>lecture</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>edited, was %1</source>
        <translation>modifié, était %1</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>modifié, était inconnu</translation>
    </message>
    <message>
        <source>raw %1   %2</source>
        <translation>brut %1   %2</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>inconnu jusqu’à l’écriture</translation>
    </message>
</context>
<context>
    <name>mb::GainsPanel</name>
    <message>
        <source>Gains</source>
        <translation>Gains</translation>
    </message>
    <message>
        <source>G · ← → 2 % · Shift 0.2 %</source>
        <translation>G · ← → 2 % · Maj 0,2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>Gains, jeu %1</translation>
    </message>
    <message>
        <source>Gains, axis %1</source>
        <translation>Gains, axe %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>Masquer les limites de la boucle</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>Diviseur</translation>
    </message>
    <message>
        <source>Limits of the axis</source>
        <translation>Limites de l’axe</translation>
    </message>
    <message>
        <source>Limits of the loop</source>
        <translation>Limites de la boucle</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: only the limits of the axis act.</source>
        <translation>Aucune boucle en mode %1&#xa0;: seules les limites de l’axe agissent.</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>Aucune boucle en mode %1&#xa0;: ces gains agissent en vitesse, position et courant.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>arrêt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::GainsWriteRow</name>
    <message>
        <source>Write gains</source>
        <translation>Écrire les gains</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Revert all staged gains</source>
        <translation>Rétablir tous les gains en attente</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valeur</numerusform>
            <numerusform>%n valeurs</numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>Écrire %1 dans le jeu %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Écrire %1</translation>
    </message>
    <message>
        <source>A gain is out of range</source>
        <translation>Un gain est hors plage</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>Aucun gain n’est modifié</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>L’appareil est occupé</translation>
    </message>
</context>
<context>
    <name>mb::GroupMotion</name>
    <message>
        <source>not prepared: hold the Arm button first</source>
        <translation>non préparé&#xa0;: maintenez d’abord le bouton Armer</translation>
    </message>
    <message>
        <source>not prepared: the selected device has to take part</source>
        <translation>non préparé&#xa0;: l’appareil sélectionné doit participer</translation>
    </message>
    <message>
        <source>not started: not every device has acknowledged its move; prepare them again</source>
        <translation>non démarré&#xa0;: tous les appareils n’ont pas acquitté leur mouvement&#x202f;; préparez-les à nouveau</translation>
    </message>
    <message>
        <source>stopped, and the others of its group with it: %1</source>
        <translation>arrêté, et les autres de son groupe avec lui&#xa0;: %1</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>il a disparu</translation>
    </message>
    <message>
        <source>not prepared: an experiment on the selected device has not ended</source>
        <translation>non préparé&#xa0;: un essai avec l’appareil sélectionné n’est pas encore terminé</translation>
    </message>
</context>
<context>
    <name>mb::GuardianCheck</name>
    <message>
        <source>stops a motor when this program is killed or hangs</source>
        <translation>arrête un moteur quand ce programme est tué ou se fige</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Check the guardian</source>
        <translation>Vérifier le gardien</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 ne peut pas être démarré : %2</translation>
    </message>
    <message>
        <source>It is in place and runs.</source>
        <translation>Il est en place et fonctionne.</translation>
    </message>
    <message>
        <source>%1 does not run as it should.</source>
        <translation>%1 ne fonctionne pas comme il devrait.</translation>
    </message>
</context>
<context>
    <name>mb::Guide</name>
    <message>
        <source>overshoot %1 % at first, %2 % now</source>
        <translation>dépassement %1 % d’abord, %2 % maintenant</translation>
    </message>
    <message>
        <source>overshoot %1 %</source>
        <translation>dépassement %1 %</translation>
    </message>
    <message>
        <source>peak current %1 A</source>
        <translation>courant de pointe %1 A</translation>
    </message>
    <message>
        <source>%1 counts beside its target at first, %2 now</source>
        <translation>à %1 incréments de sa cible d’abord, à %2 maintenant</translation>
    </message>
    <message>
        <source>%1 counts beside its target</source>
        <translation>à %1 incréments de sa cible</translation>
    </message>
</context>
<context>
    <name>mb::GuideStrip</name>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Show me where</source>
        <translation>Montrer où</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Simulated: nothing real moves. A guide says each step and waits until it has happened.</source>
        <translation>Simulé&#xa0;: rien de réel ne bouge. Un guide indique chaque étape et attend qu’elle soit faite.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 terminé</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Terminé.</translation>
    </message>
    <message>
        <source>The simulated bench is opened; the unit answers in a moment.</source>
        <translation>Ouverture du banc simulé&#x202f;; l’appareil va répondre.</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>Mesuré&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>mb::HeaderBar</name>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>Program menu</source>
        <translation>Menu du programme</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 liaison</translation>
    </message>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>%n liaison</numerusform>
            <numerusform>%n liaisons</numerusform>
        </translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>aucune alarme</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>1 notification</translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>%n notification</numerusform>
            <numerusform>%n notifications</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
</context>
<context>
    <name>mb::HelpBrowser</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
</context>
<context>
    <name>mb::HelpDesk</name>
    <message>
        <source>Help for this page</source>
        <translation>Aide de cette page</translation>
    </message>
</context>
<context>
    <name>mb::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Pages de l’aide</translation>
    </message>
</context>
<context>
    <name>mb::HistoryPanel</name>
    <message>
        <source>State A</source>
        <translation>État A</translation>
    </message>
    <message>
        <source>State B</source>
        <translation>État B</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Quels paramètres</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>Seulement les différences</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Restore what is ticked</source>
        <translation>Restaurer les éléments cochés</translation>
    </message>
    <message>
        <source>Only differences %1</source>
        <translation>Seulement les différences %1</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Tous %1</translation>
    </message>
    <message>
        <source>%1 ticked; a snapshot of what is there is taken first.</source>
        <translation>%1 cochés&#x202f;; un instantané de l’existant est pris d’abord.</translation>
    </message>
    <message>
        <source>Choose what the device has now as A to write values of B.</source>
        <translation>Choisissez comme A ce que l’appareil a maintenant pour écrire les valeurs de B.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>Restaurer %1</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>differences from A</source>
        <translation>différences avec A</translation>
    </message>
    <message>
        <source>Click sets B, Shift+click sets A.</source>
        <translation>Clic&#xa0;: B, Maj+clic&#xa0;: A.</translation>
    </message>
    <message>
        <source>Exchange A and B</source>
        <translation>Échanger A et B</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copier en texte</translation>
    </message>
    <message>
        <source>Keep or revert first</source>
        <translation>D’abord conserver ou rétablir</translation>
    </message>
</context>
<context>
    <name>mb::IdModel</name>
    <message>
        <source>err</source>
        <translation>err</translation>
    </message>
    <message>
        <source>tx</source>
        <translation>tx</translation>
    </message>
    <message>
        <source>rx</source>
        <translation>rx</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>trame d’erreur</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods</source>
        <translation>toutes les %1 ms, écart type %2 ms, écart maximal %3 ms, sur les 32 dernières périodes</translation>
    </message>
    <message>
        <source>Right click: choose the field</source>
        <translation>Clic droit&#xa0;: choisir le champ</translation>
    </message>
    <message>
        <source>Standard deviation of the last 32 periods</source>
        <translation>Écart type des 32 dernières périodes</translation>
    </message>
    <message>
        <source>The last frame; bytes that changed within 0.7 s are marked</source>
        <translation>La dernière trame&#x202f;; les octets modifiés depuis moins de 0,7 s sont marqués</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>sens</translation>
    </message>
    <message>
        <source>message</source>
        <translation>message</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>app.</translation>
    </message>
    <message>
        <source>rate Hz</source>
        <translation>fréq. Hz</translation>
    </message>
    <message>
        <source>jitter ms</source>
        <translation>gigue ms</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>trames</translation>
    </message>
    <message>
        <source>data</source>
        <translation>données</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>dernière valeur</translation>
    </message>
    <message>
        <source>last 5 s</source>
        <translation>5 dernières s</translation>
    </message>
</context>
<context>
    <name>mb::ImageText</name>
    <message>
        <source>no image yet</source>
        <translation>pas encore d’image</translation>
    </message>
    <message>
        <source>Open an Intel HEX file, or drop it here</source>
        <translation>Ouvrez un fichier Intel HEX, ou déposez-le ici</translation>
    </message>
    <message>
        <source>select a device to check it</source>
        <translation>sélectionnez un appareil pour la vérifier</translation>
    </message>
    <message>
        <source>version %1 · pages: %2</source>
        <translation>version %1 · pages&#xa0;: %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
</context>
<context>
    <name>mb::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifier</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Tout lire</translation>
    </message>
    <message>
        <source>Read every parameter of this unit</source>
        <translation>Lire tous les paramètres de cet appareil</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>boîtier</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identité</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>n° de série</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>bootloader</translation>
    </message>
    <message>
        <source>session</source>
        <translation>session</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>faults</source>
        <translation>défauts</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>surchauffe</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limites</translation>
    </message>
    <message>
        <source>changed from default</source>
        <translation>hors valeur par défaut</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>in RAM only</source>
        <translation>en RAM seulement</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Aucun appareil sélectionné</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit</source>
        <translation>Faire clignoter les voyants de cet appareil</translation>
    </message>
</context>
<context>
    <name>mb::JogPanel</name>
    <message>
        <source>Nudge −</source>
        <translation>À-coup −</translation>
    </message>
    <message>
        <source>Nudge +</source>
        <translation>À-coup +</translation>
    </message>
    <message>
        <source>Nudge backwards</source>
        <translation>À-coup en arrière</translation>
    </message>
    <message>
        <source>Nudge forwards</source>
        <translation>À-coup en avant</translation>
    </message>
    <message>
        <source>A click moves it for a tenth of a second; held, it goes on until it is let go.</source>
        <translation>Un clic le déplace pendant un dixième de seconde&#x202f;; maintenu, il continue jusqu’au relâchement.</translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message>
        <source>Journal</source>
        <translation>Registre</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Change the journal</source>
        <translation>Modifier le registre</translation>
    </message>
    <message>
        <source>On this computer</source>
        <translation>Sur cet ordinateur</translation>
    </message>
    <message>
        <source>PostgreSQL, %1</source>
        <translation>PostgreSQL, %1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>poste %1</translation>
    </message>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n entrée attend le serveur</numerusform>
            <numerusform>%n entrées attendent le serveur</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>%n appareil de cette série y figure</numerusform>
            <numerusform>%n appareils de cette série y figurent</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message>
        <source>30 s from when the unit has restarted with them</source>
        <translation>30 s à partir du redémarrage de l’appareil avec elles</translation>
    </message>
    <message>
        <source>they go back in %1 s</source>
        <translation>rétablies dans %1 s</translation>
    </message>
    <message>
        <source>they go back as soon as the motor stands</source>
        <translation>rétablies dès que le moteur est à l’arrêt</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Time until the values go back</source>
        <translation>Temps avant le rétablissement des valeurs</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · encore %n modification ensuite</numerusform>
            <numerusform>%1 · encore %n modifications ensuite</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep these values of %1?</source>
        <translation>Conserver ces valeurs de %1&#xa0;?</translation>
    </message>
    <message>
        <source>nothing goes back by itself</source>
        <translation>rien n’est rétabli automatiquement</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Rétablir</translation>
    </message>
</context>
<context>
    <name>mb::KeyBook</name>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Cette touche ne peut pas être changée.</translation>
    </message>
    <message>
        <source>%1 stops every motor, always.</source>
        <translation>%1 arrête tous les moteurs, toujours.</translation>
    </message>
    <message>
        <source>%1 is taken, %2: %3. Give that another key first.</source>
        <translation>%1 est prise, %2 : %3. Donnez-lui d’abord une autre touche.</translation>
    </message>
    <message>
        <source>%1 belongs to the control that has the focus.</source>
        <translation>%1 appartient au contrôle qui a le focus.</translation>
    </message>
</context>
<context>
    <name>mb::KeyDesk</name>
    <message>
        <source>stop every motor</source>
        <translation>arrête tous les moteurs</translation>
    </message>
    <message>
        <source>stops every motor, unless words can be typed where the focus is</source>
        <translation>arrête tous les moteurs, sauf pendant une saisie de texte</translation>
    </message>
    <message>
        <source>presses the button or ticks the box that has the focus</source>
        <translation>actionne le bouton ou coche la case qui a le focus</translation>
    </message>
    <message>
        <source>held for 1 s: arms; let go early it does nothing</source>
        <translation>maintenu 1 s&#xa0;: arme&#x202f;; relâché trop tôt, sans effet</translation>
    </message>
    <message>
        <source>keeps values that go back by themselves otherwise</source>
        <translation>garde les valeurs qui sinon reviennent d’elles-mêmes</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Production</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>page, key</comment>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>mb::KeyField</name>
    <message>
        <source>Press the new key here</source>
        <translation>Appuyez ici sur la nouvelle touche</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle touche</translation>
    </message>
</context>
<context>
    <name>mb::KeysPanel</name>
    <message>
        <source>Search commands and keys</source>
        <translation>Chercher commandes et touches</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Commandes et leurs touches</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Aucune touche</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>Tout par défaut</translation>
    </message>
    <message>
        <source>All keys are those they came with.</source>
        <translation>Toutes les touches sont celles d’origine.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>It came with: %1</source>
        <translation>Touche d’origine : %1</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Cette touche ne peut pas être changée.</translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field.</source>
        <translation>Choisissez une commande, puis appuyez sur sa nouvelle touche dans le champ.</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>Arm button: %1</source>
        <translation>Bouton Armer&#xa0;: %1</translation>
    </message>
    <message>
        <source>A motor was told to stop and was not seen to. Cut its power, or look at it.</source>
        <translation>Un moteur a reçu l’ordre de s’arrêter sans que l’arrêt soit constaté. Coupez son alimentation, ou allez voir.</translation>
    </message>
    <message>
        <source>Press to make it safe again</source>
        <translation>Appuyer pour désarmer</translation>
    </message>
    <message>
        <source>Hold for one second to arm</source>
        <translation>Maintenir une seconde pour armer</translation>
    </message>
</context>
<context>
    <name>mb::LampFace</name>
    <message>
        <source>SAFE</source>
        <translation>SÛR</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>ARMÉ</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>EN MOUVEMENT</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>ARRÊTÉ</translation>
    </message>
    <message>
        <source>STOPPING</source>
        <translation>ARRÊT EN COURS</translation>
    </message>
    <message>
        <source>MAY STILL TURN</source>
        <translation>TOURNE PEUT-ÊTRE</translation>
    </message>
    <message>
        <source>keep holding</source>
        <translation>maintenir encore</translation>
    </message>
    <message>
        <source>hold to arm</source>
        <translation>maintenir&#xa0;: armer</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>rien à armer</translation>
    </message>
    <message>
        <source>hold to re-arm</source>
        <translation>maintenir&#xa0;: réarmer</translation>
    </message>
    <message>
        <source>cut its power</source>
        <translation>couper l’alimentation</translation>
    </message>
    <message>
        <source>#88 velocity</source>
        <translation>#88 vitesse</translation>
    </message>
</context>
<context>
    <name>mb::LinkChip</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>charge %1</translation>
    </message>
    <message>
        <source>lost %1</source>
        <translation>perdus %1</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>Liaison %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::LinkOptions</name>
    <message>
        <source>Bit rate</source>
        <translation>Débit</translation>
    </message>
    <message>
        <source>find it: all rates of the protocol</source>
        <translation>le trouver&#xa0;: tous les débits du protocole</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>the computer&apos;s own RS-485 port</source>
        <translation>port RS-485 propre à l’ordinateur</translation>
    </message>
    <message>
        <source>RS-485</source>
        <translation>RS-485</translation>
    </message>
    <message>
        <source>Lets the kernel switch the driver of a port on the computer&apos;s board. Adapters on USB switch by themselves: leave it off.</source>
        <translation>Laisse le noyau commuter l’émetteur d’un port de la carte de l’ordinateur. Les adaptateurs USB commutent d’eux-mêmes&#xa0;: laissez désactivé.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Ready line (SRDY)</source>
        <translation>Ligne prêt (SRDY)</translation>
    </message>
    <message>
        <source>Reset line (MCLR)</source>
        <translation>Ligne de reset (MCLR)</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>Trames perdues</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not wired</source>
        <translation>non câblée</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>mb::LinkOwners</name>
    <message>
        <source>%1, process %2</source>
        <translation>%1, processus %2</translation>
    </message>
    <message>
        <source>%1 has this link too. Agree who drives: two masters on one motor disturb each other.</source>
        <translation>%1 utilise aussi cette liaison. Convenez de qui pilote&#xa0;: deux maîtres sur un moteur se gênent.</translation>
    </message>
    <message>
        <source>%1 has this port. Close it there, then reconnect.</source>
        <translation>%1 occupe ce port. Fermez-le là-bas, puis reconnectez.</translation>
    </message>
</context>
<context>
    <name>mb::ListCard</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::LiveStateBar</name>
    <message>
        <source>Limits and pins</source>
        <translation>Limites et entrées</translation>
    </message>
    <message>
        <source>no limit holds</source>
        <translation>aucune limite n’agit</translation>
    </message>
</context>
<context>
    <name>mb::LogPage</name>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Rechercher dans le journal</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Défauts</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Sauvegarder le journal…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Encore rien</translation>
    </message>
    <message>
        <source>Actions and faults appear here.</source>
        <translation>Les actions et les défauts apparaissent ici.</translation>
    </message>
    <message>
        <source>Log lines</source>
        <translation>Lignes du journal</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>Sauvegarder le journal</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Texte (*.log *.txt)</translation>
    </message>
    <message>
        <source>log saved to %1</source>
        <translation>journal sauvegardé dans %1</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>recherche</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1&#xa0;: %2 trames reçues, %3 envoyées, %4 rejetées, %5 erreurs</translation>
    </message>
    <message>
        <source>%1: %2 bytes received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1&#xa0;: %2 octets reçus, %3 envoyés, %4 rejetés, %5 erreurs</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>button</source>
        <translation>bouton</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Vue d’ensemble</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Conception</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Rapports</translation>
    </message>
    <message>
        <source>needs a device; open a link first</source>
        <translation>nécessite un appareil&#x202f;; ouvrez d’abord une liaison</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>banc simulé</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>la fenêtre a perdu le focus</translation>
    </message>
    <message>
        <source>The preferences hold as soon as nothing is armed, no job runs and no other window is open.</source>
        <translation>Les préférences s’appliquent dès que rien n’est armé, qu’aucune opération ne tourne et qu’aucune autre fenêtre n’est ouverte.</translation>
    </message>
    <message>
        <source>the limits were not kept: %1</source>
        <translation>les limites n’ont pas été conservées : %1</translation>
    </message>
</context>
<context>
    <name>mb::MetricsPanel</name>
    <message>
        <source>Metrics</source>
        <translation>Indicateurs</translation>
    </message>
    <message>
        <source>Metrics of A and B</source>
        <translation>Indicateurs de A et B</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>État de la boucle</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>indicateur</translation>
    </message>
    <message>
        <source>Δ B − A</source>
        <comment>difference</comment>
        <translation>Δ B − A</translation>
    </message>
    <message>
        <source>± from %1 repeats</source>
        <translation>± sur %1 répétitions</translation>
    </message>
    <message>
        <source>%1= same</source>
        <translation>%1= idem</translation>
    </message>
    <message>
        <source>SAT %1 %</source>
        <translation>SAT %1 %</translation>
    </message>
    <message>
        <source>Share of the hold in which the duty was at its limit</source>
        <translation>Part du maintien pendant laquelle le rapport cyclique était en limite</translation>
    </message>
    <message>
        <source>ILIM</source>
        <translation>ILIM</translation>
    </message>
    <message>
        <source>The current was at its limit</source>
        <translation>Le courant était en limite</translation>
    </message>
    <message>
        <source>RAMP</source>
        <translation>RAMPE</translation>
    </message>
    <message>
        <source>The drive&apos;s own ramp was on</source>
        <translation>La rampe du variateur était active</translation>
    </message>
    <message>
        <source>LIMIT SW</source>
        <translation>FDC</translation>
    </message>
    <message>
        <source>A limit switch was met</source>
        <translation>Un fin de course a été atteint</translation>
    </message>
    <message>
        <source>WINDUP %1</source>
        <translation>WINDUP %1</translation>
    </message>
    <message>
        <source>WINDUP</source>
        <translation>WINDUP</translation>
    </message>
    <message>
        <source>The duty was at its limit while I went on; that is paid back as overshoot</source>
        <translation>Le rapport cyclique était en limite alors que I continuait&#x202f;; cela se paie en dépassement</translation>
    </message>
    <message>
        <source>QUANT</source>
        <translation>QUANT</translation>
    </message>
    <message>
        <source>The step has few counts of the encoder</source>
        <translation>L’échelon compte peu d’incréments du codeur</translation>
    </message>
    <message>
        <source>LOST %1</source>
        <translation>PERDUS %1</translation>
    </message>
    <message>
        <source>Samples that are missing</source>
        <translation>Échantillons manquants</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Made on a simulated controller, and marked so for ever</source>
        <translation>Obtenu sur un contrôleur simulé, et marqué ainsi pour toujours</translation>
    </message>
    <message>
        <source>means of %1 repeats</source>
        <translation>moyennes de %1 répétitions</translation>
    </message>
    <message>
        <source>%1= same ±%2</source>
        <translation>%1= idem ±%2</translation>
    </message>
</context>
<context>
    <name>mb::ModePanel</name>
    <message>
        <source>Mode</source>
        <translation>Mode</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>mode %1</translation>
    </message>
</context>
<context>
    <name>mb::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Nobody has identified this motor yet. Identify pushes it both ways with a part of the duty, inside the limits below, and changes no gain.</source>
        <translation>Ce moteur n’a pas encore été identifié. Identifier le pousse dans les deux sens avec une partie du rapport cyclique, dans les limites ci-dessous, et ne change aucun gain.</translation>
    </message>
    <message>
        <source>good fit</source>
        <translation>bon ajustement</translation>
    </message>
    <message>
        <source>not believed</source>
        <translation>non crédible</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>filtre de vitesse</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Toutes les valeurs</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Replier</translation>
    </message>
</context>
<context>
    <name>mb::MotionTour</name>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>à vitesse</translation>
    </message>
</context>
<context>
    <name>mb::MotionWords</name>
    <message>
        <source>%1 axes</source>
        <translation>%1 axes</translation>
    </message>
    <message>
        <source>axis %1 %2</source>
        <translation>axe %1 %2</translation>
    </message>
    <message>
        <source>%1 on the adapter before</source>
        <translation>%1 sur l&apos;adaptateur précédent</translation>
    </message>
</context>
<context>
    <name>mb::MovesPanel</name>
    <message>
        <source>Moves together</source>
        <translation>Mouvements communs</translation>
    </message>
    <message>
        <source>to a position</source>
        <translation>à une position</translation>
    </message>
    <message>
        <source>by a distance</source>
        <translation>d’une distance</translation>
    </message>
    <message>
        <source>at a velocity</source>
        <translation>à une vitesse</translation>
    </message>
    <message>
        <source>Kind of the moves</source>
        <translation>Type des mouvements</translation>
    </message>
    <message>
        <source>profiled</source>
        <translation>avec profil</translation>
    </message>
    <message>
        <source>With the stored acceleration and velocity</source>
        <translation>Avec l’accélération et la vitesse mémorisées</translation>
    </message>
    <message>
        <source>With the acceleration and velocity that are stored in the device.</source>
        <translation>Avec l’accélération et la vitesse mémorisées dans l’appareil.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>Switches the motors on where they stand, and gives each its move to keep.</source>
        <translation>Met les moteurs sous tension là où ils sont, et confie à chacun son mouvement.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Start the prepared moves together</source>
        <translation>Démarrer ensemble les mouvements préparés</translation>
    </message>
    <message>
        <source>One command on the line starts all prepared moves at the same moment.</source>
        <translation>Une seule commande sur la ligne démarre tous les mouvements préparés au même instant.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Maintenir</translation>
    </message>
    <message>
        <source>Hold all of them where they are</source>
        <translation>Les maintenir tous là où ils sont</translation>
    </message>
    <message>
        <source>Brakes to a halt and holds the position. The motors stay on; STOP switches them off.</source>
        <translation>Freine jusqu’à l’arrêt et maintient la position. Les moteurs restent sous tension&#x202f;; STOP les coupe.</translation>
    </message>
    <message>
        <source>%1 takes part</source>
        <translation>%1 participe</translation>
    </message>
    <message>
        <source>Target of %1</source>
        <translation>Cible de %1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>started</source>
        <translation>démarré</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>préparé</translation>
    </message>
    <message>
        <source>being prepared</source>
        <translation>en préparation</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>garde un mouvement</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>arrêt</translation>
    </message>
    <message>
        <source>All are prepared. Start begins them at the same moment.</source>
        <translation>Tous sont préparés. Démarrer les lance au même instant.</translation>
    </message>
    <message>
        <source>Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare gives a new one; switching the unit off clears it.</source>
        <translation>L’arrêt n’efface pas un mouvement qui n’a pas commencé&#xa0;: %1 le lancerait au prochain démarrage sur cette ligne. Préparer en donne un nouveau&#x202f;; la mise hors tension l’efface.</translation>
    </message>
    <message>
        <source>Hold the Arm button. It covers all that take part.</source>
        <translation>Maintenez le bouton Armer. Il vaut pour tous les participants.</translation>
    </message>
    <message>
        <source>Prepare switches the motors on where they stand; nothing turns before Start.</source>
        <translation>Préparer met les moteurs sous tension là où ils sont&#x202f;; rien ne tourne avant Démarrer.</translation>
    </message>
    <message>
        <source>not prepared: &apos;%1&apos; is no number of counts</source>
        <translation>non préparé&#xa0;: «&#xa0;%1&#xa0;» n’est pas un nombre de counts</translation>
    </message>
</context>
<context>
    <name>mb::NoticeModel</name>
    <message>
        <source>time</source>
        <translation>heure</translation>
    </message>
    <message>
        <source>device</source>
        <translation>appareil</translation>
    </message>
    <message>
        <source>what</source>
        <translation>quoi</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::OverviewPage</name>
    <message>
        <source>Overview</source>
        <translation>Vue d’ensemble</translation>
    </message>
    <message>
        <source>load</source>
        <translation>charge</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>erreurs</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Frames received that no controller family knows: somebody else&apos;s traffic</source>
        <translation>Trames reçues qu’aucune famille de contrôleurs ne connaît&#xa0;: trafic étranger</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>aller-retour</translation>
    </message>
    <message>
        <source>Load of the last minute</source>
        <translation>Charge de la dernière minute</translation>
    </message>
</context>
<context>
    <name>mb::OwnProposal</name>
    <message>
        <source>own</source>
        <translation>propre</translation>
    </message>
    <message>
        <source>Own proposal</source>
        <translation>Proposition personnelle</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>calme</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>vif</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>robuste</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>nerveux</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>Ms ≤ %1</source>
        <translation>Ms ≤ %1</translation>
    </message>
    <message>
        <source>The device cannot have this set: %1</source>
        <translation>L’appareil ne peut pas avoir ce jeu&#xa0;: %1</translation>
    </message>
    <message>
        <source>Held at τc %1 by: %2</source>
        <translation>Tenu à τc %1 par&#xa0;: %2</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>proposition %1</translation>
    </message>
</context>
<context>
    <name>mb::PageKeys</name>
    <message>
        <source>Keys: %1</source>
        <translation>Touches&#xa0;: %1</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
</context>
<context>
    <name>mb::PageMap</name>
    <message>
        <source>Flash pages</source>
        <translation>Pages de flash</translation>
    </message>
    <message>
        <source>%1 of %2 pages written</source>
        <translation>%1 pages sur %2 écrites</translation>
    </message>
    <message>
        <source> · must not be interrupted</source>
        <translation> · ne pas interrompre</translation>
    </message>
    <message>
        <source>page %1: waiting</source>
        <translation>page %1&#xa0;: en attente</translation>
    </message>
    <message>
        <source>page %1: being written</source>
        <translation>page %1&#xa0;: écriture en cours</translation>
    </message>
    <message>
        <source>page %1: written after it was sent again</source>
        <translation>page %1&#xa0;: écrite après renvoi</translation>
    </message>
    <message>
        <source>page %1: written</source>
        <translation>page %1&#xa0;: écrite</translation>
    </message>
    <message>
        <source>page %1: sent again</source>
        <translation>page %1&#xa0;: renvoyée</translation>
    </message>
    <message>
        <source>page %1: not in the image</source>
        <translation>page %1&#xa0;: absente de l’image</translation>
    </message>
</context>
<context>
    <name>mb::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
</context>
<context>
    <name>mb::PageTabs</name>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
</context>
<context>
    <name>mb::ParameterCommands</name>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>Ce qui a été écrit avant est en vigueur&#x202f;; le reste est encore en attente. Rien n’a été mémorisé.</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>Rien ne prouve la mémorisation en flash. Mémorisez à nouveau, sans couper l’alimentation.</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>Rien n’est conservé.</translation>
    </message>
    <message>
        <source>What was written before it is in force. Undo takes it back.</source>
        <translation>Ce qui a été écrit avant est en vigueur. Annuler le reprend.</translation>
    </message>
</context>
<context>
    <name>mb::ParameterDelegate</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterFoot</name>
    <message>
        <source>What the parameter does</source>
        <translation>Ce que fait le paramètre</translation>
    </message>
    <message>
        <source>%1 edited</source>
        <translation>%1 modifiés</translation>
    </message>
    <message>
        <source>%1 out of range</source>
        <translation>%1 hors plage</translation>
    </message>
    <message>
        <source>%1 without answer</source>
        <translation>%1 sans réponse</translation>
    </message>
    <message>
        <source>%1 in RAM</source>
        <translation>%1 en RAM</translation>
    </message>
    <message>
        <source>%1 stored</source>
        <translation>%1 mémorisés</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 supposés</translation>
    </message>
    <message>
        <source>%1 not persistent</source>
        <translation>%1 volatils</translation>
    </message>
    <message>
        <source>Choose a parameter to see what it does.</source>
        <translation>Choisissez un paramètre pour voir ce qu’il fait.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>↑↓ row · Enter edit · %1 write</source>
        <translation>↑↓ ligne · Entrée modifier · %1 écrire</translation>
    </message>
</context>
<context>
    <name>mb::ParameterGroups</name>
    <message>
        <source>1 parameter</source>
        <translation>1 paramètre</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 paramètres</translation>
    </message>
    <message>
        <source>not kept over a power cycle</source>
        <translation>perdu à la mise hors tension</translation>
    </message>
    <message>
        <source>%1 not kept over a power cycle</source>
        <translation>%1 perdus à la mise hors tension</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHead</name>
    <message>
        <source>Undo the last edit or write</source>
        <translation>Annuler la dernière modification ou écriture</translation>
    </message>
    <message>
        <source>Redo the edit or write</source>
        <translation>Rétablir la modification ou l’écriture</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Tout lire</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Instantané</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>Plus pour les paramètres</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHeader</name>
    <message>
        <source>Columns</source>
        <translation>Colonnes</translation>
    </message>
</context>
<context>
    <name>mb::ParameterModel</name>
    <message>
        <source>edited, was %1</source>
        <translation>modifié, était %1</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>inconnu jusqu’à l’écriture</translation>
    </message>
    <message>
        <source>default</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>modifié, était inconnu</translation>
    </message>
    <message>
        <source>no answer, retry</source>
        <translation>sans réponse, réessayer</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>non lu</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>d’un fichier</translation>
    </message>
    <message>
        <source>Can only be read.</source>
        <translation>Lecture seule.</translation>
    </message>
    <message>
        <source>Is cleared with the faults, not by writing.</source>
        <translation>S’efface avec les défauts, pas par écriture.</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1, par défaut %2</translation>
    </message>
    <message>
        <source>%1 is 100 %</source>
        <translation>%1 vaut 100 %</translation>
    </message>
    <message>
        <source>Not kept over a power cycle.</source>
        <translation>Perdu à la mise hors tension.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>paramètre</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clé</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valeur</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unité</translation>
    </message>
    <message>
        <source>state</source>
        <translation>état</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>brut</translation>
    </message>
</context>
<context>
    <name>mb::ParameterTools</name>
    <message>
        <source>Search parameters</source>
        <translation>Rechercher des paramètres</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Quels paramètres</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Différents</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Modifiés</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Tous %1</translation>
    </message>
    <message>
        <source>Changed %1</source>
        <translation>Différents %1</translation>
    </message>
    <message>
        <source>Edited %1</source>
        <translation>Modifiés %1</translation>
    </message>
    <message>
        <source>Errors %1</source>
        <translation>Erreurs %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterView</name>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Copy as key=value</source>
        <translation>Copier en key=value</translation>
    </message>
    <message>
        <source>Revert the edit</source>
        <translation>Annuler la modification</translation>
    </message>
    <message>
        <source>Set to the default, %1</source>
        <translation>Mettre à la valeur par défaut, %1</translation>
    </message>
</context>
<context>
    <name>mb::ParametersPage</name>
    <message>
        <source>Open a parameter file…</source>
        <translation>Ouvrir un fichier de paramètres…</translation>
    </message>
    <message>
        <source>Open a parameter file</source>
        <translation>Ouvrir un fichier de paramètres</translation>
    </message>
    <message>
        <source>Import parameters</source>
        <translation>Importer des paramètres</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>Exporter les paramètres</translation>
    </message>
    <message>
        <source>reads all parameters</source>
        <translation>lit tous les paramètres</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>recherche</translation>
    </message>
    <message>
        <source>writes what is staged</source>
        <translation>écrit ce qui est en attente</translation>
    </message>
    <message>
        <source>undoes the last edit, or else the last write to the unit</source>
        <translation>annule la dernière modification, sinon la dernière écriture dans l’appareil</translation>
    </message>
    <message>
        <source>shows the history of the unit, or its values</source>
        <translation>affiche l’historique de l’appareil, ou ses valeurs</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Sélectionnez un appareil</translation>
    </message>
    <message>
        <source>Its parameters appear here. A parameter file can be looked at and compared without a device.</source>
        <translation>Ses paramètres apparaissent ici. Un fichier de paramètres peut être consulté et comparé sans appareil.</translation>
    </message>
    <message>
        <source>No parameters in the bootloader</source>
        <translation>Pas de paramètres dans le bootloader</translation>
    </message>
    <message>
        <source>%1 has no application running. Write firmware to it, then its parameters can be read.</source>
        <translation>%1 n’exécute aucune application. Écrivez-y un firmware, puis ses paramètres pourront être lus.</translation>
    </message>
    <message>
        <source>No parameters</source>
        <translation>Aucun paramètre</translation>
    </message>
    <message>
        <source>%1 has none.</source>
        <translation>%1 n’en a pas.</translation>
    </message>
    <message>
        <source>Compare with a parameter file</source>
        <translation>Comparer avec un fichier de paramètres</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>rétablit la dernière modification ou écriture</translation>
    </message>
</context>
<context>
    <name>mb::PdfText</name>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 sur %2</translation>
    </message>
    <message>
        <source>DEMO, a simulated unit</source>
        <translation>DÉMO, un appareil simulé</translation>
    </message>
</context>
<context>
    <name>mb::PlotBoard</name>
    <message>
        <source>DEMO</source>
        <translation>DÉMO</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>RELECTURE</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 signaux, %2 échantillons/s, %3 sur %4 perdus</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>réf. %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotExport</name>
    <message>
        <source>Export plot</source>
        <translation>Exporter la courbe</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l’image</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Copier les nombres</translation>
    </message>
    <message>
        <source>Copy summary</source>
        <translation>Copier le résumé</translation>
    </message>
    <message>
        <source>Export PNG…</source>
        <translation>Exporter en PNG…</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Image PNG (*.png)</translation>
    </message>
    <message>
        <source>Export SVG…</source>
        <translation>Exporter en SVG…</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dessin SVG (*.svg)</translation>
    </message>
    <message>
        <source>Export PDF…</source>
        <translation>Exporter en PDF…</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Document PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exporter en CSV…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
</context>
<context>
    <name>mb::PlotLayoutBook</name>
    <message>
        <source>Save layout</source>
        <translation>Sauvegarder la disposition</translation>
    </message>
    <message>
        <source>Save layout as…</source>
        <translation>Sauvegarder la disposition sous…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Begin like this with every %1</source>
        <translation>Commencer ainsi avec chaque %1</translation>
    </message>
    <message>
        <source>Begin with the usual for every %1</source>
        <translation>Commencer comme d’habitude avec chaque %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotScrubber</name>
    <message>
        <source>Whole session</source>
        <translation>Toute la session</translation>
    </message>
    <message>
        <source>The whole session: drag the box or click to scroll back, End returns to the present.
The recording goes on meanwhile.</source>
        <translation>Toute la session&#xa0;: faites glisser le cadre ou cliquez pour revenir en arrière, Fin ramène au présent.
L’enregistrement continue entre-temps.</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
    <message>
        <source>Plot</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <source>Pause view	P</source>
        <translation>Figer la vue	P</translation>
    </message>
    <message>
        <source>Back to live	P</source>
        <translation>Revenir au direct	P</translation>
    </message>
    <message>
        <source>Fit time and value	0</source>
        <translation>Ajuster temps et valeur	0</translation>
    </message>
    <message>
        <source>Cursors A and B	L</source>
        <translation>Curseurs A et B	L</translation>
    </message>
</context>
<context>
    <name>mb::PlotsBar</name>
    <message>
        <source>window %1 ms</source>
        <translation>fenêtre %1 ms</translation>
    </message>
    <message>
        <source>window %1 s</source>
        <translation>fenêtre %1 s</translation>
    </message>
    <message>
        <source>window %1 min</source>
        <translation>fenêtre %1 min</translation>
    </message>
    <message>
        <source>window %1 h</source>
        <translation>fenêtre %1 h</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Figer la vue</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>Suivre en direct</translation>
    </message>
    <message>
        <source>The recording goes on.</source>
        <translation>L’enregistrement continue.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Against time, one signal against another, or amplitude against frequency of what is seen or of A … B</source>
        <translation>En fonction du temps, un signal en fonction d’un autre, ou amplitude en fonction de la fréquence, sur la partie visible ou A … B</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Durée de l’axe du temps</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Déclencheur&#xa0;: s’immobilise sur un front ou un niveau</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Curseurs A et B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Ajuster temps et valeur</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>Garder la partie visible comme référence</translation>
    </message>
    <message>
        <source>Layouts: save, restore, reset</source>
        <translation>Dispositions&#xa0;: sauvegarder, restaurer, réinitialiser</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF; samples as CSV or MCAP</source>
        <translation>L’image en PNG, SVG ou PDF&#x202f;; les échantillons en CSV ou MCAP</translation>
    </message>
</context>
<context>
    <name>mb::PlotsPage</name>
    <message>
        <source>No device yet</source>
        <translation>Pas encore d’appareil</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; its signals appear here.</source>
        <translation>Ouvrez une liaison, ou le banc simulé depuis le menu&#x202f;; ses signaux apparaissent ici.</translation>
    </message>
    <message>
        <source>Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box
double click or End returns to the present · right click for more</source>
        <translation>La molette zoome le temps, Ctrl+molette les valeurs, Maj+molette déplace · glisser déplace · Maj+glisser zoome dans un cadre
double-clic ou Fin ramène au présent · clic droit pour plus</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>Rien n’est tracé</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right or under a device at the left, or drag it here.</source>
        <translation>Double-cliquez sur un signal dans la liste à droite ou sous un appareil à gauche, ou faites-le glisser ici.</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>courbe écrite dans %1</translation>
    </message>
    <message>
        <source>pauses the plots, and goes on</source>
        <translation>fige les courbes, puis les reprend</translation>
    </message>
    <message>
        <source>fits time and value</source>
        <translation>ajuste temps et valeur</translation>
    </message>
    <message>
        <source>cursors: arrows move one, C changes to the other</source>
        <translation>curseurs&#xa0;: les flèches en déplacent un, C passe à l’autre</translation>
    </message>
    <message>
        <source>watches for a trigger, or no more</source>
        <translation>guette un déclenchement, ou plus</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>enregistre, ou termine l’enregistrement</translation>
    </message>
    <message>
        <source>in the plots: less or more time</source>
        <translation>dans les courbes&#xa0;: moins ou plus de temps</translation>
    </message>
    <message>
        <source>in the plots: larger or smaller values</source>
        <translation>dans les courbes&#xa0;: valeurs plus grandes ou plus petites</translation>
    </message>
    <message>
        <source>in the plots: writes a note at this time</source>
        <translation>dans les courbes&#xa0;: écrit une note à cet instant</translation>
    </message>
    <message>
        <source>Note at this time…	N</source>
        <translation>Note à cet instant…	N</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>Garder la partie visible comme référence</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Supprimer les références</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Signal dérivé…</translation>
    </message>
    <message>
        <source>Spectrum of what is seen</source>
        <translation>Spectre de la partie visible</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Déclencheur&#xa0;: s’immobilise sur un front ou un niveau</translation>
    </message>
    <message>
        <source>Export samples…</source>
        <translation>Exporter les échantillons…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>sombre</translation>
    </message>
    <message>
        <source>light</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>comme le bureau</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Nothing moves but data</source>
        <translation>Rien ne bouge sauf les données</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Thème</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Taille du texte</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Animations</translation>
    </message>
    <message>
        <source>Notebook, recordings</source>
        <translation>Carnet d’essais, enregistrements</translation>
    </message>
    <message>
        <source>Settings, layouts</source>
        <translation>Réglages, dispositions</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the folder: %1</source>
        <translation>Ouvrir le dossier&#xa0;: %1</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>contraste élevé</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm and degrees</source>
        <translation>tr/min et degrés</translation>
    </message>
    <message>
        <source>With every verdict in production</source>
        <translation>À chaque verdict en production</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>Sons</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Gardien</translation>
    </message>
</context>
<context>
    <name>mb::ProductionHead</name>
    <message>
        <source>recipe</source>
        <translation>recette</translation>
    </message>
    <message>
        <source>image</source>
        <translation>image</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>paramètres</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>règle de numéro</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>autotest</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Link that units are put on</source>
        <translation>Liaison où se branchent les appareils</translation>
    </message>
    <message>
        <source>Serial number, scanned or typed</source>
        <translation>Numéro de série, scanné ou saisi</translation>
    </message>
    <message>
        <source>Scan or type a serial number</source>
        <translation>Scannez ou saisissez un numéro de série</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Ouvrir une recette…</translation>
    </message>
    <message>
        <source>Hold to arm self-tests</source>
        <translation>Maintenir&#xa0;: armer les autotests</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>No recipe yet</source>
        <translation>Pas encore de recette</translation>
    </message>
    <message>
        <source>ARMED, hold to disarm</source>
        <translation>ARMÉ, maintenir&#xa0;: désarmer</translation>
    </message>
    <message>
        <source>%1, not open</source>
        <translation>%1, non ouvert</translation>
    </message>
</context>
<context>
    <name>mb::ProductionPage</name>
    <message>
        <source>Production</source>
        <translation>Production</translation>
    </message>
    <message>
        <source>Last ten units</source>
        <translation>Dix derniers appareils</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>Sound with every verdict</source>
        <translation>Son à chaque verdict</translation>
    </message>
    <message>
        <source>tests the last unit again</source>
        <translation>teste à nouveau le dernier appareil</translation>
    </message>
    <message>
        <source>sets it aside, ready for the next</source>
        <translation>le met de côté, prêt pour le suivant</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Ouvrir une recette</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Recettes (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The self-test turns the motor: %1</source>
        <translation>L’autotest fait tourner le moteur&#xa0;: %1</translation>
    </message>
    <message>
        <source>not started: open a link first</source>
        <translation>non démarré&#xa0;: ouvrez d’abord une liaison</translation>
    </message>
    <message>
        <source>not started: open a recipe first</source>
        <translation>non démarré&#xa0;: ouvrez d’abord une recette</translation>
    </message>
    <message>
        <source>no unit here has the serial number %1</source>
        <translation>aucun appareil ici ne porte le numéro de série %1</translation>
    </message>
    <message>
        <source>test again</source>
        <translation>retester</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>mettre de côté</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>numéro de série</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>quitter</translation>
    </message>
    <message>
        <source>stops every motor</source>
        <translation>arrête tous les moteurs</translation>
    </message>
    <message>
        <source>not tested again: %1</source>
        <translation>pas testé à nouveau&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProfileFields</name>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>Velocity of the profile</source>
        <translation>Vitesse du profil</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>Acceleration of the profile</source>
        <translation>Accélération du profil</translation>
    </message>
    <message>
        <source>The profile needs a velocity up to %1 counts/s.</source>
        <translation>Le profil demande une vitesse jusqu’à %1 counts/s.</translation>
    </message>
    <message>
        <source>The profile needs an acceleration up to %1 counts/s²; 0 is none.</source>
        <translation>Le profil demande une accélération jusqu’à %1 counts/s²&#x202f;; 0 signifie aucune.</translation>
    </message>
</context>
<context>
    <name>mb::ProfilePanel</name>
    <message>
        <source>What only you know</source>
        <translation>Ce que vous seul savez</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecte</translation>
    </message>
    <message>
        <source>How this unit is spoken to. The scan finds it out; choose another only if you know better.</source>
        <translation>La façon de parler à cet appareil. La recherche la détermine&#x202f;; n’en choisissez une autre qu’en connaissance de cause.</translation>
    </message>
    <message>
        <source>dialect as found</source>
        <translation>dialecte trouvé</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Speak another dialect?</source>
        <translation>Parler un autre dialecte&#x202f;?</translation>
    </message>
    <message>
        <source>Speak to this unit as %1?</source>
        <translation>Parler à cet appareil en %1&#x202f;?</translation>
    </message>
    <message>
        <source>Speak it</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>dialect as found: %1</source>
        <translation>dialecte trouvé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProgrammerBox</name>
    <message>
        <source>Programmer</source>
        <translation>Programmateur</translation>
    </message>
    <message>
        <source>What writes the flash: one of the list, or the name that the program gives to another</source>
        <translation>Ce qui écrit la flash&#xa0;: un élément de la liste, ou le nom que le programme donne à un autre</translation>
    </message>
    <message>
        <source>Port of the programmer</source>
        <translation>Port du programmateur</translation>
    </message>
    <message>
        <source>Where the programmer, or the line to the bootloader, is plugged in</source>
        <translation>Où est branché le programmateur, ou la ligne vers le bootloader</translation>
    </message>
    <message>
        <source>at</source>
        <translation>sur</translation>
    </message>
    <message>
        <source>the device&apos;s own line</source>
        <translation>la ligne propre à l’appareil</translation>
    </message>
    <message>
        <source>at USB</source>
        <translation>sur USB</translation>
    </message>
    <message>
        <source>Choose a programmer</source>
        <translation>Choisir un programmateur</translation>
    </message>
    <message>
        <source>No serial port is plugged in; choose or name the one of the programmer</source>
        <translation>Aucun port série n’est branché&#x202f;; choisissez ou nommez celui du programmateur</translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message>
        <source>Save the machine into a folder</source>
        <translation>Sauvegarder la machine dans un dossier</translation>
    </message>
    <message>
        <source>Open the folder of a machine</source>
        <translation>Ouvrir le dossier d’une machine</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>%n appareil sauvegardé dans %1</numerusform>
            <numerusform>%n appareils sauvegardés dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>scales and limits of the project are in force</source>
        <translation>échelles et limites du projet en vigueur</translation>
    </message>
    <message>
        <source>dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks</source>
        <translation>le dialecte %1 du dossier n’est pas en vigueur : choisissez-le dans l’inspecteur si c’est celui qu’il parle</translation>
    </message>
</context>
<context>
    <name>mb::ProposalCard</name>
    <message>
        <source>quiet, forgiving</source>
        <translation>calme, tolérant</translation>
    </message>
    <message>
        <source>hardly overshoots</source>
        <translation>dépasse à peine</translation>
    </message>
    <message>
        <source>fastest rise</source>
        <translation>montée la plus rapide</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>calme</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>vif</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>raw %1</source>
        <translation>brut %1</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>Proposal: %1</source>
        <translation>Proposition&#xa0;: %1</translation>
    </message>
    <message>
        <source>over</source>
        <translation>dép.</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>établt</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>GM</source>
        <translation>GM</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>PM</source>
        <translation>PM</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>pointe</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
</context>
<context>
    <name>mb::ProposalList</name>
    <message>
        <source>own</source>
        <translation>propre</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Propositions</translation>
    </message>
    <message>
        <source>to be found anew</source>
        <translation>seront cherchés à nouveau</translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message>
        <source>State of the queue</source>
        <translation>État de la file</translation>
    </message>
    <message>
        <source>Progress of the queue</source>
        <translation>Progression de la file</translation>
    </message>
    <message>
        <source>Pause after this unit</source>
        <translation>Pause après cet appareil</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Refaire les échecs</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Sauvegarder en CSV…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Ended before its time: %1</source>
        <translation>Terminée avant l’heure&#xa0;: %1</translation>
    </message>
    <message>
        <source>Pauses after this unit</source>
        <translation>S’arrête après cet appareil</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Unit %1 of %2</source>
        <translation>Appareil %1 sur %2</translation>
    </message>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>Terminé, reste %n appareil</numerusform>
            <numerusform>Terminé, restent %n appareils</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1 of %2 units</source>
        <translation>Terminé&#xa0;: %1 appareils sur %2</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Rien en cours</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>encore %1 s environ</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 faits</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 en attente</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 échecs</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>%1 refusés</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>moyenne %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueBoard</name>
    <message>
        <source>Go on with it</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>A queue runs already.</source>
        <translation>Une file est déjà en cours.</translation>
    </message>
    <message>
        <source>Open an image or a recipe first.</source>
        <translation>Ouvrez d’abord une image ou une recette.</translation>
    </message>
    <message>
        <source>Tick the units first.</source>
        <translation>Cochez d’abord les appareils.</translation>
    </message>
    <message>
        <source>Save what was done</source>
        <translation>Sauvegarder ce qui a été fait</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>the units are in %1</source>
        <translation>les appareils sont dans %1</translation>
    </message>
    <message>
        <source>The last queue of this recipe was cut off: %1 done, %2 open</source>
        <translation>La dernière file de cette recette a été interrompue&#xa0;: %1 faits, %2 ouverts</translation>
    </message>
    <message>
        <source>What has ended stays as it is; ticked units are taken along.</source>
        <translation>Ce qui est terminé reste tel quel&#xa0;; les appareils cochés sont ajoutés.</translation>
    </message>
    <message>
        <source>One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on disk: after a crash the queue goes on.</source>
        <translation>Un appareil à la fois par bus, les bus en parallèle. Les vrais appareils gardent cet ordinateur éveillé. Le registre est sur disque&#xa0;: après un plantage, la file reprend.</translation>
    </message>
    <message>
        <source>Every unit is backed up before and compared afterwards; the journal has it.</source>
        <translation>Chaque appareil est sauvegardé avant et comparé après&#xa0;; le registre en garde trace.</translation>
    </message>
    <message>
        <source>not tried again: %1</source>
        <translation>pas réessayé&#xa0;: %1</translation>
    </message>
    <message>
        <source>not tried again: it was served by %1; tick it and start</source>
        <translation>pas réessayé : traité avec %1 ; cochez-le et démarrez</translation>
    </message>
    <message>
        <source>%1 waits until this queue has ended</source>
        <translation>%1 attend la fin de cette file</translation>
    </message>
</context>
<context>
    <name>mb::QueueChecks</name>
    <message>
        <source>recipe checked</source>
        <translation>recette vérifiée</translation>
    </message>
    <message>
        <source>no image, no recipe</source>
        <translation>ni image, ni recette</translation>
    </message>
    <message>
        <source>all motors stopped</source>
        <translation>tous les moteurs à l’arrêt</translation>
    </message>
    <message>
        <source>a motor is moving</source>
        <translation>un moteur tourne</translation>
    </message>
    <message>
        <source>no other master</source>
        <translation>aucun autre maître</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>autre maître, ou numéro pris deux fois</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>bus %1 V</translation>
    </message>
    <message>
        <source>bus voltage not known</source>
        <translation>tension du bus inconnue</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Avant de démarrer</translation>
    </message>
</context>
<context>
    <name>mb::QueueHead</name>
    <message>
        <source>recipe</source>
        <translation>recette</translation>
    </message>
    <message>
        <source>image</source>
        <translation>image</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>paramètres</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>règle de numéros</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Ouvrir une image…</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Ouvrir une recette…</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aucune pour l’instant</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>Ouvrir une image de firmware</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Ouvrir une recette</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Recettes (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Write a recipe</source>
        <translation>Écrire une recette</translation>
    </message>
</context>
<context>
    <name>mb::QueueModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>numéro de série</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>appareil</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>step</source>
        <translation>étape</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>progression</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>result</source>
        <translation>résultat</translation>
    </message>
</context>
<context>
    <name>mb::QueueSide</name>
    <message>
        <source>The self-test turns the motor: %1. Hold Arm in the header once the queue runs.</source>
        <translation>L’autotest fait tourner le moteur&#xa0;: %1. Maintenez Armer dans l’en-tête une fois la file lancée.</translation>
    </message>
</context>
<context>
    <name>mb::QueueTable</name>
    <message>
        <source>Every unit of this family</source>
        <translation>Chaque appareil de cette famille</translation>
    </message>
    <message>
        <source>Units of the queue</source>
        <translation>Appareils de la file</translation>
    </message>
    <message>
        <source>Every %1</source>
        <translation>Tous les %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueText</name>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>vérifié</translation>
    </message>
    <message>
        <source>%1 parameters equal</source>
        <translation>%1 paramètres égaux</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>déjà %1</translation>
    </message>
    <message>
        <source>read back after the restart</source>
        <translation>relu après le redémarrage</translation>
    </message>
    <message>
        <source>safe to unplug, resumes</source>
        <translation>peut être débranché, reprend</translation>
    </message>
    <message>
        <source>do not unplug</source>
        <translation>ne pas débrancher</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>cut off, goes on</source>
        <translation>interrompu, reprend</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omis</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>tronqué</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>échec&#xa0;: %1</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>refusé avant le départ</translation>
    </message>
    <message>
        <source>number taken twice</source>
        <translation>numéro pris deux fois</translation>
    </message>
    <message>
        <source>in its bootloader</source>
        <translation>dans son bootloader</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>le moteur est en mouvement</translation>
    </message>
    <message>
        <source>another master drives it</source>
        <translation>un autre maître le commande</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Contrôle préalable</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sauvegarde</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Autotest</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Comparison and proof</source>
        <translation>Comparaison et vérification</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fait</translation>
    </message>
    <message>
        <source>hold Arm in the header</source>
        <translation>maintenir Armer dans l’en-tête</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>écrit, non prouvé</translation>
    </message>
    <message>
        <source>answers with %1, as before</source>
        <translation>répond avec %1, comme avant</translation>
    </message>
</context>
<context>
    <name>mb::RamBlock</name>
    <message>
        <source>In RAM, not in flash</source>
        <translation>En RAM, pas en flash</translation>
    </message>
    <message>
        <source>Time until the device stores by itself</source>
        <translation>Temps avant la mémorisation par l’appareil lui-même</translation>
    </message>
    <message>
        <source>Store and prove</source>
        <translation>Mémoriser et vérifier</translation>
    </message>
    <message>
        <source>%1 s to go</source>
        <translation>encore %1 s</translation>
    </message>
    <message>
        <source>not proved</source>
        <translation>non prouvé</translation>
    </message>
    <message>
        <source>Read back and equal. Lost at power-off until it is stored.</source>
        <translation>Relu et égal. Perdu à la mise hors tension tant que non mémorisé.</translation>
    </message>
    <message>
        <source>Read back and equal. Do not cut power yet.</source>
        <translation>Relu et égal. Ne coupez pas encore l’alimentation.</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>%1 de plus.</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to %1 s.</source>
        <translation>L’appareil devrait avoir mémorisé de lui-même. Sa propre vérification prend jusqu’à %1 s.</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Reading %1 of %2</source>
        <translation>Lecture de %1 sur %2</translation>
    </message>
    <message>
        <source>no answer, the values are old</source>
        <translation>pas de réponse, les valeurs sont anciennes</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>%1 of %2 are read, %3 gave no answer</source>
        <translation>%1 sur %2 lus, %3 sans réponse</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>pas encore lu</translation>
    </message>
    <message>
        <source>%1 of %2 known</source>
        <translation>%1 sur %2 connus</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>les %1 sont lus</translation>
    </message>
    <message>
        <source>all %1 read in %2</source>
        <translation>les %1 lus en %2</translation>
    </message>
    <message>
        <source>%1, values for %2 from a file</source>
        <translation>%1, valeurs pour %2 lues dans un fichier</translation>
    </message>
</context>
<context>
    <name>mb::RecipeEditor</name>
    <message>
        <source>New recipe</source>
        <translation>Nouvelle recette</translation>
    </message>
    <message>
        <source>Fields of the recipe</source>
        <translation>Champs de la recette</translation>
    </message>
    <message>
        <source>The file that is saved, line by line</source>
        <translation>Le fichier sauvegardé, ligne par ligne</translation>
    </message>
    <message>
        <source>What is wrong with the recipe</source>
        <translation>Ce qui ne va pas dans la recette</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>Sauvegarder la recette</translation>
    </message>
    <message>
        <source>Recipe %1</source>
        <translation>Recette %1</translation>
    </message>
    <message>
        <source>Keep the recipe</source>
        <translation>Conserver la recette</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Recettes (*.json)</translation>
    </message>
    <message>
        <source>This recipe is not saved.</source>
        <translation>Cette recette n’est pas sauvegardée.</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>L’abandonner</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>Continuer à écrire</translation>
    </message>
    <message>
        <source>No mistake in the recipe</source>
        <translation>Aucune erreur dans la recette</translation>
    </message>
    <message>
        <source>Give the recipe a name.</source>
        <translation>Donnez un nom à la recette.</translation>
    </message>
</context>
<context>
    <name>mb::RecipeForm</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Famille</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>Fichier de firmware</translation>
    </message>
    <message>
        <source>Other way in</source>
        <translation>Autre accès</translation>
    </message>
    <message>
        <source>Parameter file</source>
        <translation>Fichier de paramètres</translation>
    </message>
    <message>
        <source>Save them where the unit does not by itself</source>
        <translation>Les mémoriser si l’appareil ne le fait pas lui-même</translation>
    </message>
    <message>
        <source>First number to give</source>
        <translation>Premier numéro à attribuer</translation>
    </message>
    <message>
        <source>Self-test: the motor turns</source>
        <translation>Autotest : le moteur tourne</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Durée, s</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Jeu de gains</translation>
    </message>
    <message>
        <source>Travel at most, counts</source>
        <translation>Course maximale, pas</translation>
    </message>
    <message>
        <source>Speed at most, counts/s</source>
        <translation>Vitesse maximale, pas/s</translation>
    </message>
    <message>
        <source>Current at most, A</source>
        <translation>Courant maximal, A</translation>
    </message>
    <message>
        <source>Duty at most, 0 to 1</source>
        <translation>Rapport cyclique maximal, 0 à 1</translation>
    </message>
    <message>
        <source>What the self-test accepts</source>
        <translation>Ce que l’autotest accepte</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Accepté</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>counts both ways</source>
        <translation>compte dans les deux sens</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Choisir : %1</translation>
    </message>
    <message>
        <source>none: over its own link</source>
        <translation>aucun : par sa propre liaison</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>par exemple %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>field, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 à 1</translation>
    </message>
</context>
<context>
    <name>mb::RecipeText</name>
    <message>
        <source>%1 · sha %2</source>
        <translation>%1 · sha %2</translation>
    </message>
    <message>
        <source>%1 · version %2 · sha %3</source>
        <translation>%1 · version %2 · sha %3</translation>
    </message>
    <message>
        <source>%1 · %2 values</source>
        <translation>%1 · %2 valeurs</translation>
    </message>
    <message>
        <source>next free from %1</source>
        <translation>premier libre à partir de %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordStrip</name>
    <message>
        <source>Record…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Writes every frame of this link to a candump log or a Vector ASC file</source>
        <translation>Écrit chaque trame de cette liaison dans un journal candump ou un fichier Vector ASC</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Record the frames of %1</source>
        <translation>Enregistrer les trames de %1</translation>
    </message>
    <message>
        <source>Vector ASC log (*.asc)</source>
        <translation>Journal Vector ASC (*.asc)</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>Journal candump (*.log)</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>rien n’est enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>The recording has ended: %1. %2 frames are missing in it.</source>
        <translation>L’enregistrement est terminé&#xa0;: %1. Il y manque %2 trames.</translation>
    </message>
    <message>
        <source>Recording  %1   %2 frames   %3   %4 lost   %5</source>
        <translation>Enregistrement  %1   %2 trames   %3   %4 perdues   %5</translation>
    </message>
</context>
<context>
    <name>mb::Recorder</name>
    <message>
        <source>The last session did not end by itself. What it recorded is in %1.</source>
        <translation>La dernière session ne s’est pas terminée normalement. Son enregistrement est dans %1.</translation>
    </message>
    <message>
        <source>Samples are recorded on disk again, those of the meantime too.</source>
        <translation>Les échantillons sont de nouveau enregistrés sur disque, ceux de l’intervalle aussi.</translation>
    </message>
    <message>
        <source>Samples are not recorded on disk: %1</source>
        <translation>Les échantillons ne sont pas enregistrés sur disque&#xa0;: %1</translation>
    </message>
    <message>
        <source>What the last session recorded waits for the next start: %1</source>
        <translation>Ce que la dernière session a enregistré attend le prochain démarrage : %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordingControl</name>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Sauvegarder</translation>
    </message>
    <message>
        <source>Keeps everything that devices send, beginning with the last %1.
What was recorded lately is on disk all the time and outlives a crash.</source>
        <translation>Conserve tout ce que les appareils envoient, à partir des dernières %1.
Les données récentes sont en permanence sur disque et survivent à un plantage.</translation>
    </message>
    <message>
        <source>recording written to %1</source>
        <translation>enregistrement écrit dans %1</translation>
    </message>
    <message>
        <source>not recorded: %1</source>
        <translation>non enregistré&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 samples</source>
        <translation>%1 · %2 · %3 échantillons</translation>
    </message>
    <message>
        <source>last %1 on disk · %2</source>
        <translation>dernières %1 sur disque · %2</translation>
    </message>
</context>
<context>
    <name>mb::ReplayBar</name>
    <message>
        <source>Recording that is played</source>
        <translation>Enregistrement en lecture</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>RELECTURE</translation>
    </message>
    <message>
        <source>Shows what was recorded. Nothing is sent, no motor moves.</source>
        <translation>Montre ce qui a été enregistré. Rien n’est envoyé, aucun moteur ne bouge.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Plays the recording from where it stands, or halts it there</source>
        <translation>Lit l’enregistrement à partir de la position actuelle, ou l’y arrête</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Vitesse de relecture</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>Vitesse à laquelle l’enregistrement est lu</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>aussi vite que possible</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Position dans l’enregistrement</translation>
    </message>
    <message>
        <source>Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s</source>
        <translation>Position dans l’enregistrement&#x202f;; les flèches la déplacent de 1 s, Page haut et Page bas de 10 s</translation>
    </message>
    <message>
        <source>%1: looking through it, %2 %</source>
        <translation>%1&#xa0;: analyse, %2 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>enregistré le %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportOrder</name>
    <message>
        <source>Write report</source>
        <translation>Écrire le rapport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>the report is in %1</source>
        <translation>le rapport est dans %1</translation>
    </message>
    <message>
        <source>no report: %1</source>
        <translation>pas de rapport&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Montée, 10 à 90 %</translation>
    </message>
    <message>
        <source>Settling to 2 %</source>
        <translation>Établissement à 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Undershoot of the way back</source>
        <translation>Sous-dépassement au retour</translation>
    </message>
    <message>
        <source>Error at rest</source>
        <translation>Erreur au repos</translation>
    </message>
    <message>
        <source>IAE</source>
        <translation>IAE</translation>
    </message>
    <message>
        <source>ITAE</source>
        <translation>ITAE</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>Courant de pointe</translation>
    </message>
    <message>
        <source>Chatter of the duty, RMS</source>
        <translation>Agitation du rapport cyclique, RMS</translation>
    </message>
    <message>
        <source>Time at the duty limit</source>
        <translation>Temps en limite de rapport cyclique</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Bruit de mesure</translation>
    </message>
    <message>
        <source>step</source>
        <translation>échelon</translation>
    </message>
    <message>
        <source>square wave</source>
        <translation>signal carré</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampe</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>sinus</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>chirp</translation>
    </message>
    <message>
        <source>random steps</source>
        <translation>échelons aléatoires</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>position</source>
        <translation>position</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 fois</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>tronqué</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>stopped by the guard “%1”</source>
        <translation>arrêté par la surveillance «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>DEMO: this unit is simulated. Nothing here was measured on a motor.</source>
        <translation>DÉMO&#xa0;: cet appareil est simulé. Rien ici n’a été mesuré sur un moteur.</translation>
    </message>
    <message>
        <source>Report on %1</source>
        <translation>Rapport sur %1</translation>
    </message>
    <message>
        <source>Made on %1 with %2</source>
        <translation>Établi le %1 avec %2</translation>
    </message>
    <message>
        <source>There are no trials of this unit in the notebook.</source>
        <translation>Le carnet ne contient aucun essai de cet appareil.</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulé</translation>
    </message>
    <message>
        <source>Firmware %1</source>
        <translation>Firmware %1</translation>
    </message>
    <message>
        <source>s since the edge</source>
        <translation>s depuis le front</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Essai %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>target</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, mesuré</translation>
    </message>
    <message>
        <source>duty, %</source>
        <translation>rapport cyclique, %</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Indicateur</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Gain</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Parameters of this set that have their default: %1</source>
        <translation>Paramètres de ce jeu à leur valeur par défaut&#xa0;: %1</translation>
    </message>
    <message>
        <source>travel ± %1</source>
        <translation>course ± %1</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>vitesse %1</translation>
    </message>
    <message>
        <source>current %1</source>
        <translation>courant %1</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>rapport cyclique %1</translation>
    </message>
    <message>
        <source>Trial %1, %2 loop</source>
        <translation>Essai %1, boucle de %2</translation>
    </message>
    <message>
        <source>Trial %1, open loop</source>
        <translation>Essai %1, boucle ouverte</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>gain slot %1</source>
        <translation>jeu de gains %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>firmware %1</translation>
    </message>
    <message>
        <source>motor seen stopped</source>
        <translation>arrêt du moteur constaté</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>arrêt non confirmé</translation>
    </message>
    <message>
        <source>%1 samples, %2 lost</source>
        <translation>%1 échantillons, %2 perdus</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Rien n’a été enregistré.</translation>
    </message>
    <message>
        <source>It ran within: %1.</source>
        <translation>Exécuté dans les limites&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Note&#xa0;: %1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Excitation</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Montée</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Établissement</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>History of the unit</source>
        <translation>Historique de l’appareil</translation>
    </message>
    <message>
        <source>The newest %1 of %2 trials.</source>
        <translation>Les %1 plus récents de %2 essais.</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Conservé</translation>
    </message>
    <message>
        <source>Proposed, nothing was written</source>
        <translation>Proposé, rien n’a été écrit</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Rétabli</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Refusé</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>none, as fresh as the position</source>
        <translation>aucun, aussi récente que la position</translation>
    </message>
    <message>
        <source>rolling, %1</source>
        <translation>glissante, %1</translation>
    </message>
    <message>
        <source>in blocks, %1</source>
        <translation>par blocs, %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>Gain K</translation>
    </message>
    <message>
        <source>Lag τ</source>
        <translation>Constante de temps τ</translation>
    </message>
    <message>
        <source>Friction kS</source>
        <translation>Frottement kS</translation>
    </message>
    <message>
        <source>% duty</source>
        <translation>% rapp. cycl.</translation>
    </message>
    <message>
        <source>Velocity filter of the device: %1</source>
        <translation>Filtre de vitesse de l’appareil&#xa0;: %1</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échec</translation>
    </message>
    <message>
        <source>What the model was judged by:</source>
        <translation>Critères de jugement du modèle&#xa0;:</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Proposé</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Brut</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Prédit</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>Pic de sensibilité Ms</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Marge de gain</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Marge de phase</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>en avant</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>en arrière</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prédit</translation>
    </message>
    <message>
        <source>The step of the proof, predicted and measured</source>
        <translation>L’échelon de vérification, prédit et mesuré</translation>
    </message>
    <message>
        <source>Magnitude and phase of the open loop</source>
        <translation>Module et phase de la boucle ouverte</translation>
    </message>
    <message>
        <source>magnitude of the loop, dB</source>
        <translation>module de la boucle, dB</translation>
    </message>
    <message>
        <source>phase of the loop, °</source>
        <translation>phase de la boucle, °</translation>
    </message>
    <message>
        <source>Tuning of the %1 loop</source>
        <translation>Réglage de la boucle&#xa0;: %1</translation>
    </message>
    <message>
        <source>trials %1</source>
        <translation>essais %1</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Famille</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numéro de série</translation>
    </message>
    <message>
        <source>Connected at</source>
        <translation>Raccordé à</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Bootloader</source>
        <translation>Bootloader</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecte</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>%1 of %2 differ from their default and are set in bold.</source>
        <translation>%1 sur %2 diffèrent de leur valeur par défaut et sont en gras.</translation>
    </message>
    <message>
        <source>Resistance R, Ω</source>
        <translation>Résistance R, Ω</translation>
    </message>
    <message>
        <source>Friction, V</source>
        <translation>Frottement, V</translation>
    </message>
    <message>
        <source>Gain 1/Ke, counts/s per V</source>
        <translation>Gain 1/Ke, counts/s par V</translation>
    </message>
    <message>
        <source>Encoder counts both ways</source>
        <translation>Le codeur compte dans les deux sens</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Autotest</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modification</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1 depuis %2</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>RÉUSSI</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>ÉCHEC</translation>
    </message>
    <message>
        <source>Not finished</source>
        <translation>Non terminé</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Served</source>
        <translation>Traité</translation>
    </message>
    <message>
        <source>Number given</source>
        <translation>Numéro attribué</translation>
    </message>
    <message>
        <source>Parameters of the recipe</source>
        <translation>Paramètres de la recette</translation>
    </message>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>%n dans l’appareil, relu</numerusform>
            <numerusform>%n dans l’appareil, relus</numerusform>
        </translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Maintenance</translation>
    </message>
    <message>
        <source>Cause or note</source>
        <translation>Cause ou note</translation>
    </message>
    <message>
        <source>Every service of this unit</source>
        <translation>Toutes les interventions sur cet appareil</translation>
    </message>
    <message>
        <source>Service card of %1</source>
        <translation>Fiche de service de %1</translation>
    </message>
    <message>
        <source>Parameters that differ from their default</source>
        <translation>Paramètres qui diffèrent de leur valeur par défaut</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>Les %1 premiers sur %2.</translation>
    </message>
    <message>
        <source>Counts/s per duty</source>
        <translation>Points/s par rapport cyclique</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Cohérence</translation>
    </message>
    <message>
        <source>Believed</source>
        <translation>Retenu</translation>
    </message>
    <message>
        <source>magnitude of the motor, dB</source>
        <translation>gain du moteur, dB</translation>
    </message>
    <message>
        <source>phase of the motor, °</source>
        <translation>phase du moteur, °</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modèle</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mesuré</translation>
    </message>
    <message>
        <source>Magnitude and phase of the motor, measured and of its model</source>
        <translation>Gain et phase du moteur, mesurés et selon son modèle</translation>
    </message>
    <message>
        <source>Frequency response of the motor</source>
        <translation>Réponse fréquentielle du moteur</translation>
    </message>
    <message>
        <source>Sines of duty around a speed at which it never reverses, the last on %1. Believed and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of the movement at least (coherence).</source>
        <translation>Sinusoïdes de rapport cyclique autour d’une vitesse à laquelle il ne s’inverse jamais, la dernière le %1. Retenues et tracées : %2 sur %3. Dix mesures par oscillation, et la sinusoïde explique au moins 0.9 du mouvement (cohérence).</translation>
    </message>
    <message>
        <source>Load one way kG</source>
        <translation>Charge dans un sens kG</translation>
    </message>
    <message>
        <source>Gain forwards</source>
        <translation>Gain en avant</translation>
    </message>
    <message>
        <source>Gain backwards</source>
        <translation>Gain en arrière</translation>
    </message>
    <message>
        <source>Noise at rest σ</source>
        <translation>Bruit au repos σ</translation>
    </message>
    <message>
        <source>Set-points that it can follow: at most %1 and %2</source>
        <translation>Consignes qu’il peut suivre&#xa0;: au plus %1 et %2</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>à examiner</translation>
    </message>
    <message>
        <source>Order to motion</source>
        <translation>Ordre au mouvement</translation>
    </message>
    <message>
        <source>Dead time θ</source>
        <translation>Temps mort θ</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Breakaway forwards</source>
        <translation>Décollement en avant</translation>
    </message>
    <message>
        <source>Breakaway backwards</source>
        <translation>Décollement en arrière</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>Reconnu par</translation>
    </message>
    <message>
        <source>its place; another unit may stand there</source>
        <translation>sa place ; un autre appareil peut s&apos;y trouver</translation>
    </message>
    <message>
        <source>Friction, share of duty</source>
        <translation>Frottement, fraction du rapport cyclique</translation>
    </message>
    <message>
        <source>Gain, counts/s at full duty</source>
        <translation>Gain, counts/s à plein rapport cyclique</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>Non conservé</translation>
    </message>
    <message>
        <source>duty %1, which stands in for a limit of current</source>
        <translation>rapport cyclique %1, qui remplace une limite de courant</translation>
    </message>
    <message>
        <source>%1 (forgotten)</source>
        <translation>%1 (oublié)</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>bande : ± du modèle</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Proposition</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Bounded by</source>
        <translation>Borné par</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>choisie</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>courant, %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportsPage</name>
    <message>
        <source>Reports</source>
        <translation>Rapports</translation>
    </message>
    <message>
        <source>Nothing to report yet</source>
        <translation>Encore rien à rapporter</translation>
    </message>
    <message>
        <source>The cards of units, their tunings and their trials appear here.</source>
        <translation>Les fiches des appareils, leurs réglages et leurs essais apparaissent ici.</translation>
    </message>
    <message>
        <source>Search the reports</source>
        <translation>Rechercher dans les rapports</translation>
    </message>
    <message>
        <source>Reports, newest first</source>
        <translation>Rapports, le plus récent en premier</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>Écrire le rapport…</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Aperçu du rapport</translation>
    </message>
    <message>
        <source>writes the report that is looked at</source>
        <translation>écrit le rapport affiché</translation>
    </message>
    <message>
        <source>goes to the search</source>
        <translation>va à la recherche</translation>
    </message>
    <message>
        <source>Card of %1</source>
        <translation>Fiche de %1</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Réglage de %1</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 essais</translation>
    </message>
    <message>
        <source>Trial #%1 of %2</source>
        <translation>Essai n° %1 de %2</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>Ce qui est listé</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Fiches</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Réglage</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Registre</translation>
    </message>
    <message>
        <source>Note on this entry</source>
        <translation>Note sur cette entrée</translation>
    </message>
    <message>
        <source>Note on this entry of the journal</source>
        <translation>Note sur cette entrée du registre</translation>
    </message>
    <message>
        <source>Size of the report</source>
        <translation>Taille du rapport</translation>
    </message>
    <message>
        <source>Pages, A4</source>
        <translation>Pages, A4</translation>
    </message>
    <message>
        <source>Label, 62 × 29 mm</source>
        <translation>Étiquette, 62 × 29 mm</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Sauvegarder en CSV…</translation>
    </message>
    <message>
        <source>The entries of the journal that are listed, as a table</source>
        <translation>Les entrées du registre listées, en tableau</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>Sauvegarder le registre</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>the journal is in %1</source>
        <translation>le registre est dans %1</translation>
    </message>
</context>
<context>
    <name>mb::ResolutionMeter</name>
    <message>
        <source>Resolution: off</source>
        <translation>Résolution&#xa0;: arrêt</translation>
    </message>
    <message>
        <source>Resolution: %1 steps</source>
        <translation>Résolution&#xa0;: %1 pas</translation>
    </message>
    <message>
        <source>The device knows this value as %1 whole steps: the smallest change is %2 %.</source>
        <translation>L’appareil connaît cette valeur en %1 pas entiers&#xa0;: la plus petite variation est de %2 %.</translation>
    </message>
    <message>
        <source>%1 LSB</source>
        <translation>%1 LSB</translation>
    </message>
    <message>
        <source>%1 k LSB</source>
        <translation>%1 k LSB</translation>
    </message>
</context>
<context>
    <name>mb::ResponsePlot</name>
    <message>
        <source>DEMO</source>
        <translation>DÉMO</translation>
    </message>
    <message>
        <source>t = 0 at the edge, mean of %1 · %2 samples, %3 lost</source>
        <translation>t = 0 au front, moyenne de %1 · %2 échantillons, %3 perdus</translation>
    </message>
    <message>
        <source>t = 0 at the edge · %1 samples, %2 lost</source>
        <translation>t = 0 au front · %1 échantillons, %2 perdus</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Réponses</translation>
    </message>
    <message>
        <source>%1 #%2</source>
        <translation>%1 n° %2</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>±2 % band</source>
        <translation>bande ±2 %</translation>
    </message>
    <message>
        <source>%1 peak %2 %</source>
        <translation>%1 pic %2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 établi en %2</translation>
    </message>
    <message>
        <source>%1: duty at %2 % limit, %3</source>
        <translation>%1&#xa0;: rapport cyclique à la limite de %2 %, %3</translation>
    </message>
    <message>
        <source>%1: current at its limit, %2</source>
        <translation>%1&#xa0;: courant en limite, %2</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>limite %1 %</translation>
    </message>
    <message>
        <source>limit %1 A</source>
        <translation>limite %1 A</translation>
    </message>
</context>
<context>
    <name>mb::RoutePanel</name>
    <message>
        <source>Way in</source>
        <translation>Accès</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programmateur</translation>
    </message>
    <message>
        <source>Programmer or port and where it is plugged in, as after --via on the command line</source>
        <translation>Programmateur ou port et où il est branché, comme après --via en ligne de commande</translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation>Microcontrôleur</translation>
    </message>
    <message>
        <source>Which microcontroller the unit has</source>
        <translation>Microcontrôleur dont l’appareil est équipé</translation>
    </message>
    <message>
        <source>Erase what the unit has stored: its gains are lost</source>
        <translation>Effacer ce que l’appareil a mémorisé&#xa0;: ses gains sont perdus</translation>
    </message>
    <message>
        <source>What is not known of it…</source>
        <translation>Ce que l’on n’en sait pas…</translation>
    </message>
    <message>
        <source>What the maker does not tell of the bootloader, with the likely values</source>
        <translation>Ce que le fabricant ne dit pas du bootloader, avec les valeurs probables</translation>
    </message>
</context>
<context>
    <name>mb::SamplesWindow</name>
    <message>
        <source>%1 s, %2 samples, %3 lost</source>
        <translation>%1 s, %2 échantillons, %3 perdus</translation>
    </message>
    <message>
        <source>; the end of the file is missing</source>
        <translation>; la fin du fichier manque</translation>
    </message>
    <message>
        <source>%1 (recorded samples)</source>
        <translation>%1 (échantillons enregistrés)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Ajuster temps et valeur</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Curseurs</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Voies</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>Échantillons enregistrés</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>shows everything</source>
        <translation>affiche tout</translation>
    </message>
    <message>
        <source>shows or hides the cursors</source>
        <translation>affiche ou masque les curseurs</translation>
    </message>
    <message>
        <source>closes this window</source>
        <translation>ferme cette fenêtre</translation>
    </message>
    <message>
        <source>shows these keys</source>
        <translation>affiche ces touches</translation>
    </message>
    <message>
        <source>%1: no samples</source>
        <translation>%1&#xa0;: aucun échantillon</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Un seul export à la fois&#xa0;: %1 est en cours d’écriture.</translation>
    </message>
    <message>
        <source>; the file has more, of which nothing is shown: it is too large for the memory</source>
        <translation> ; le fichier en contient davantage, dont rien n’est montré : il est trop grand pour la mémoire</translation>
    </message>
</context>
<context>
    <name>mb::SavedLimits</name>
    <message>
        <source>Kept limits</source>
        <translation>Limites conservées</translation>
    </message>
    <message>
        <source>kept limits</source>
        <translation>limites conservées</translation>
    </message>
    <message>
        <source>Name of the limits</source>
        <translation>Nom des limites</translation>
    </message>
    <message>
        <source>Choose limits that were kept for this unit, or type a name to keep the present ones under</source>
        <translation>Choisissez des limites conservées pour cet appareil, ou saisissez un nom pour conserver les limites actuelles</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Keep these limits under this name</source>
        <translation>Conserver ces limites sous ce nom</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Oublier</translation>
    </message>
    <message>
        <source>Forget the limits of this name</source>
        <translation>Oublier les limites de ce nom</translation>
    </message>
</context>
<context>
    <name>mb::ScanStrip</name>
    <message>
        <source>What the scan looks for</source>
        <translation>Ce que cherche la recherche</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>Progression de la recherche</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Annuler la recherche</translation>
    </message>
    <message>
        <source>Ends the search; what it has found stays.</source>
        <translation>Arrête la recherche&#x202f;; ce qu’elle a trouvé reste.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>mb::SendPanel</name>
    <message>
        <source>Send a frame</source>
        <translation>Envoyer une trame</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identifiant</translation>
    </message>
    <message>
        <source>id, such as 7FF</source>
        <translation>id, par exemple 7FF</translation>
    </message>
    <message>
        <source>Hexadecimal; a whole frame such as 02061405#8125 may be pasted here</source>
        <translation>Hexadécimal&#x202f;; une trame entière telle que 02061405#8125 peut être collée ici</translation>
    </message>
    <message>
        <source>Length of the identifier</source>
        <translation>Longueur de l’identifiant</translation>
    </message>
    <message>
        <source>11 bits</source>
        <translation>11 bits</translation>
    </message>
    <message>
        <source>29 bits</source>
        <translation>29 bits</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>data, such as 81 25 11</source>
        <translation>données, par exemple 81 25 11</translation>
    </message>
    <message>
        <source>Repeat every</source>
        <translation>Répéter toutes les</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Période</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>Maintenir pour envoyer</translation>
    </message>
    <message>
        <source>End repeating</source>
        <translation>Arrêter la répétition</translation>
    </message>
    <message>
        <source>What is typed here is decoded before it is sent</source>
        <translation>Ce qui est saisi ici est décodé avant l’envoi</translation>
    </message>
    <message>
        <source>Makes a motor move: %1</source>
        <translation>Met un moteur en mouvement&#xa0;: %1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>The link does not take frames as fast as they are sent</source>
        <translation>La liaison n’accepte pas les trames aussi vite qu’elles sont envoyées</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>%1 envoyées</translation>
    </message>
    <message>
        <source>%1 sent, then: %2</source>
        <translation>%1 envoyées, puis&#xa0;: %2</translation>
    </message>
    <message>
        <source>the page was left</source>
        <translation>la page a été quittée</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>la fenêtre a perdu le focus</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>aucun décodeur ne connaît cet identifiant</translation>
    </message>
    <message>
        <source>%1 of %2 #%3   %4</source>
        <translation>%1 de %2 #%3   %4</translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message>
        <source>today %1</source>
        <translation>aujourd’hui %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>hier %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 is used by %2 too</source>
        <translation>%1 est aussi utilisé par %2</translation>
    </message>
    <message>
        <source>agree who drives: two masters disturb each other</source>
        <translation>convenez de qui pilote&#xa0;: deux maîtres se gênent</translation>
    </message>
    <message>
        <source>The program ended unexpectedly (%1). What was measured is kept. Open again: %2?</source>
        <translation>Le programme s’est terminé de façon inattendue (%1). Les mesures sont conservées. Rouvrir&#xa0;: %2&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>%n appareil</numerusform>
            <numerusform>%n appareils</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
</context>
<context>
    <name>mb::SessionKeeper</name>
    <message>
        <source>This session cannot be kept: %1</source>
        <translation>Cette session ne peut pas être conservée&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::SetPointPanel</name>
    <message>
        <source>Set-point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Enter applies it while the motor runs; it never starts one.</source>
        <translation>Entrée l’applique pendant que le moteur tourne&#x202f;; elle n’en démarre jamais un.</translation>
    </message>
    <message>
        <source>Set-point, slider</source>
        <translation>Consigne, curseur</translation>
    </message>
    <message>
        <source>Hide drive options</source>
        <translation>Masquer les options</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>Arrêter et compter depuis 0</translation>
    </message>
    <message>
        <source>Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor that runs would jump.</source>
        <translation>Arrête le moteur et fait de l’endroit où il se trouve la position 0. Il ne repart qu’avec Lancer&#xa0;: un moteur en marche sauterait.</translation>
    </message>
    <message>
        <source>device</source>
        <translation>appareil</translation>
    </message>
    <message>
        <source>No set-point. Enter a number up to ± %1.</source>
        <translation>Pas de consigne. Saisissez un nombre jusqu’à ± %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number. Enter one up to ± %2.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre. Saisissez-en un jusqu’à ± %2.</translation>
    </message>
    <message>
        <source>%1 is no device number. Enter the number of the device to follow.</source>
        <translation>%1 n’est pas un numéro d’appareil. Saisissez le numéro de l’appareil à suivre.</translation>
    </message>
    <message>
        <source>%1 is beyond the range of ± %2. Enter less, or widen the range.</source>
        <translation>%1 dépasse la plage de ± %2. Saisissez moins, ou élargissez la plage.</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>maintenant %1</translation>
    </message>
    <message>
        <source>Drive options</source>
        <translation>Options</translation>
    </message>
</context>
<context>
    <name>mb::SetPointRange</name>
    <message>
        <source>Range ±</source>
        <translation>Plage ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>Range of the set-point, either way</source>
        <translation>Plage de la consigne, dans chaque sens</translation>
    </message>
    <message>
        <source>A set-point beyond it is refused: the limit of the hand, not of the drive.</source>
        <translation>Une consigne au-delà est refusée&#xa0;: limite de l’opérateur, pas du variateur.</translation>
    </message>
    <message>
        <source>at once, as a step</source>
        <translation>immédiatement, en échelon</translation>
    </message>
    <message>
        <source>full range in %1</source>
        <translation>pleine plage en %1</translation>
    </message>
    <message>
        <source>How fast the set-point moves</source>
        <translation>Vitesse de variation de la consigne</translation>
    </message>
    <message>
        <source>This program moves the set-point no faster, whatever is typed.</source>
        <translation>Ce programme ne fait pas varier la consigne plus vite, quelle que soit la saisie.</translation>
    </message>
</context>
<context>
    <name>mb::SideDocks</name>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>shows or hides the devices</source>
        <translation>affiche ou masque les appareils</translation>
    </message>
    <message>
        <source>shows or hides the inspector</source>
        <translation>affiche ou masque l’inspecteur</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>Afficher les appareils</translation>
    </message>
</context>
<context>
    <name>mb::SignalBook</name>
    <message>
        <source>The signal needs a name.</source>
        <translation>Le signal doit avoir un nom.</translation>
    </message>
    <message>
        <source>There is a derived signal of this name.</source>
        <translation>Un signal dérivé porte déjà ce nom.</translation>
    </message>
    <message>
        <source>%1 may be one of %2</source>
        <translation>%1 peut être l’un de %2</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>Ajouter un signal</translation>
    </message>
    <message>
        <source>double click or drag</source>
        <translation>double-cliquer ou glisser</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>Signaux pouvant être tracés</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Signal dérivé…</translation>
    </message>
    <message>
        <source>A formula over signals: derivative, moving average, difference …</source>
        <translation>Une formule sur des signaux&#xa0;: dérivée, moyenne glissante, différence …</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>dérivé</translation>
    </message>
    <message>
        <source>%1
right click removes the signal</source>
        <translation>%1
un clic droit supprime le signal</translation>
    </message>
    <message>
        <source>%1
double click plots it, drag it to a pane or below them</source>
        <translation>%1
un double-clic le trace&#x202f;; faites-le glisser sur un graphique ou en dessous</translation>
    </message>
    <message>
        <source>Remove this derived signal</source>
        <translation>Supprimer ce signal dérivé</translation>
    </message>
</context>
<context>
    <name>mb::SlotPanel</name>
    <message>
        <source>Gain slot, edit and run</source>
        <translation>Jeu de gains, édition et exécution</translation>
    </message>
    <message>
        <source>The slot that is edited and that runs. Changing it disarms.</source>
        <translation>Le jeu édité et actif. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Edit one slot while another runs</source>
        <translation>Éditer un jeu pendant qu’un autre est actif</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Jeu</translation>
    </message>
    <message>
        <source>edit and run</source>
        <translation>édité et actif</translation>
    </message>
    <message>
        <source>Gain slot that is edited</source>
        <translation>Jeu de gains édité</translation>
    </message>
    <message>
        <source>Gain slot that runs</source>
        <translation>Jeu de gains actif</translation>
    </message>
    <message>
        <source>The slot of the next run. Changing it disarms.</source>
        <translation>Le jeu de la prochaine exécution. Le modifier désarme.</translation>
    </message>
    <message>
        <source>Editing slot</source>
        <translation>Éditer le jeu</translation>
    </message>
    <message>
        <source>running</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Réunir</translation>
    </message>
    <message>
        <source>Edit the slot that runs</source>
        <translation>Éditer le jeu actif</translation>
    </message>
    <message>
        <source>Split: both are slot %1 now.</source>
        <translation>Séparés&#xa0;: tous deux sont maintenant le jeu %1.</translation>
    </message>
    <message>
        <source>Split: edits go to slot %1, slot %2 runs.</source>
        <translation>Séparés&#xa0;: les modifications vont au jeu %1, le jeu %2 est actif.</translation>
    </message>
</context>
<context>
    <name>mb::SpectrumView</name>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>fréquence, Hz</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitude</translation>
    </message>
    <message>
        <source>amplitude, %1</source>
        <translation>amplitude, %1</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>what is seen</source>
        <translation>partie visible</translation>
    </message>
    <message>
        <source>, Hann window, peak values. </source>
        <translation>, fenêtre de Hann, valeurs de crête. </translation>
    </message>
</context>
<context>
    <name>mb::SpokenNames</name>
    <message>
        <source>Places</source>
        <translation>Emplacements</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Fichiers</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Type de fichier</translation>
    </message>
</context>
<context>
    <name>mb::StagedEdits</name>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
</context>
<context>
    <name>mb::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Ajouter une liaison</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Try with a simulated motor</source>
        <translation>Essayer avec un moteur simulé</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Ouvrir le banc simulé</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Firmware on this computer</source>
        <translation>Firmwares sur cet ordinateur</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Choose the folder whose images are listed here</source>
        <translation>Choisir le dossier dont les images sont listées ici</translation>
    </message>
    <message>
        <source>First time here?</source>
        <translation>Première visite&#x202f;?</translation>
    </message>
    <message>
        <source>STOP works on key press, everywhere, also while you type (use Esc then). It is software: keep a hardware stop in the supply.</source>
        <translation>STOP agit dès l’appui, partout, même pendant la saisie (utilisez alors Esc). C’est du logiciel&#xa0;: gardez un arrêt matériel dans l’alimentation.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Wiring guides</source>
        <translation>Câblage</translation>
    </message>
    <message>
        <source>Sessions and recordings that you have opened stand here.</source>
        <translation>Les sessions et enregistrements déjà ouverts figurent ici.</translation>
    </message>
    <message>
        <source>No image (.hex) in this folder.</source>
        <translation>Aucune image (.hex) dans ce dossier.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Contrôleurs de toutes les familles avec un vrai cadencement de bus&#x202f;; rien de réel ne peut bouger.</translation>
    </message>
</context>
<context>
    <name>mb::StateGlyph</name>
    <message>
        <source>online</source>
        <translation>en ligne</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>in bootloader</source>
        <translation>dans le bootloader</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>number 0</source>
        <translation>numéro 0</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>défaut</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>mémorisé</translation>
    </message>
    <message>
        <source>RAM, not in flash</source>
        <translation>RAM, pas en flash</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>modifié</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>hors plage</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supposé</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volatil</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>occupé</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>enregistrement</translation>
    </message>
</context>
<context>
    <name>mb::StationDialog</name>
    <message>
        <source>Journal of this station</source>
        <translation>Registre de ce poste</translation>
    </message>
    <message>
        <source>Name of this station</source>
        <translation>Nom de ce poste</translation>
    </message>
    <message>
        <source>Server that stations share</source>
        <translation>Serveur partagé par les postes</translation>
    </message>
    <message>
        <source>Without a server the journal is in the file of this computer alone. With one, every entry is there first and delivered as soon as the server answers; numbers come in blocks of five.</source>
        <translation>Sans serveur, le registre n’est que dans le fichier de cet ordinateur. Avec un serveur, chaque entrée y est d’abord, puis elle est remise dès que le serveur répond ; les numéros viennent par blocs de cinq.</translation>
    </message>
</context>
<context>
    <name>mb::StationLamp</name>
    <message>
        <source>%1 self-test</source>
        <translation>autotest de %1</translation>
    </message>
    <message>
        <source>turns in a moment</source>
        <translation>tourne dans un instant</translation>
    </message>
    <message>
        <source>self-tests</source>
        <translation>autotests</translation>
    </message>
    <message>
        <source>nothing turns here</source>
        <translation>rien ne tourne ici</translation>
    </message>
    <message>
        <source>Arm button</source>
        <translation>bouton Armer</translation>
    </message>
</context>
<context>
    <name>mb::StatusBar</name>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>échantillons %1   perdus %2   mémoire %3</translation>
    </message>
</context>
<context>
    <name>mb::StepText</name>
    <message>
        <source>%1, predicted</source>
        <translation>%1, prédit</translation>
    </message>
    <message>
        <source>measured, forwards</source>
        <translation>mesuré, en avant</translation>
    </message>
    <message>
        <source>measured, backwards</source>
        <translation>mesuré, en arrière</translation>
    </message>
    <message>
        <source>measured: %1 % over, settled after %2</source>
        <translation>mesuré&#xa0;: %1 % de dépassement, établi après %2</translation>
    </message>
    <message>
        <source>%1 % over</source>
        <translation>%1 % dép.</translation>
    </message>
    <message>
        <source>%1 A peak</source>
        <translation>pointe %1 A</translation>
    </message>
    <message>
        <source>±2 %</source>
        <translation>±2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 : établt %2</translation>
    </message>
    <message>
        <source>%1 does not settle</source>
        <translation>%1 ne s’établit pas</translation>
    </message>
    <message>
        <source>measured: peak %1, %2 % over</source>
        <translation>mesuré : pointe %1, dép. %2 %</translation>
    </message>
    <message>
        <source>measured: settles %1</source>
        <translation>mesuré : établt %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Step of %1 %2</source>
        <translation>Échelon de %1 %2</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>bande : ± du modèle</translation>
    </message>
</context>
<context>
    <name>mb::StepsPanel</name>
    <message>
        <source>Steps of the update</source>
        <translation>Étapes de la mise à jour</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>mb::StimulusBar</name>
    <message>
        <source>there, until it has settled, and back</source>
        <translation>aller, jusqu’à stabilisation, et retour</translation>
    </message>
    <message>
        <source>to and fro, 0.5 Hz</source>
        <translation>va-et-vient, 0,5 Hz</translation>
    </message>
    <message>
        <source>evenly there and back</source>
        <translation>aller et retour réguliers</translation>
    </message>
    <message>
        <source>1 Hz, six swings</source>
        <translation>1 Hz, six oscillations</translation>
    </message>
    <message>
        <source>0.1 to 15 Hz in 30 s</source>
        <translation>0,1 à 15 Hz en 30 s</translation>
    </message>
    <message>
        <source>random bits of 125 ms</source>
        <translation>bits aléatoires de 125 ms</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Excitation</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>Where the experiment begins and ends; empty: where the motor is, or 0</source>
        <translation>Où l’expérience commence et finit&#x202f;; vide&#xa0;: où est le moteur, ou 0</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Where the loop is asked to go</source>
        <translation>Où la boucle doit aller</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>maintien</translation>
    </message>
    <message>
        <source>Time of the stimulus</source>
        <translation>Durée de l’excitation</translation>
    </message>
    <message>
        <source>Seconds; empty: the usual, and a step ends once it has settled</source>
        <translation>Secondes&#x202f;; vide&#xa0;: comme d’habitude, et un échelon finit dès qu’il est établi</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>établi</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>habituel</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Répétitions</translation>
    </message>
    <message>
        <source>Each repeat starts a little later between two samples: together they show what is finer than the telemetry</source>
        <translation>Chaque répétition commence un peu plus tard entre deux échantillons&#xa0;: ensemble, elles montrent ce qui est plus fin que la télémétrie</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>here</source>
        <translation>ici</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>montée</translation>
    </message>
    <message>
        <source>time</source>
        <translation>durée</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Saisissez où la boucle doit aller.</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 n’est pas un nombre.</translation>
    </message>
    <message>
        <source>The time is 0.001 to %1 s.</source>
        <translation>La durée va de 0,001 à %1 s.</translation>
    </message>
</context>
<context>
    <name>mb::StopButton</name>
    <message>
        <source>Space · Esc</source>
        <translation>Espace · Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop every motor</source>
        <translation>Arrêter tous les moteurs</translation>
    </message>
    <message>
        <source>Stop every motor  Space, Esc, Pause</source>
        <translation>Arrêter tous les moteurs  Espace, Esc, Pause</translation>
    </message>
</context>
<context>
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>environ %n min</numerusform>
            <numerusform>environ %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Essayer</translation>
    </message>
    <message>
        <source>Try it: %1</source>
        <translation>Essayer&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::SweepPanel</name>
    <message>
        <source>%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one way, %8.</source>
        <translation>%1 sinus de %2 à %3 Hz, alternativement dans les deux sens&#xa0;: rapport cyclique %4 ± %5 %, au plus %6 counts/s, %7 counts dans un sens, %8.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Réponse fréquentielle</translation>
    </message>
    <message>
        <source>Measures the motor by sines and draws it over its model, as far as it may be trusted</source>
        <translation>Mesure le moteur par des sinus et la trace sur son modèle, dans la mesure où elle est fiable</translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>console</source>
        <translation>console</translation>
    </message>
    <message>
        <source>autotune</source>
        <translation>autoréglage</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>recette</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>ailleurs</translation>
    </message>
    <message>
        <source>States of this unit</source>
        <translation>États de cet appareil</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>Aujourd’hui, %1</translation>
    </message>
    <message>
        <source>like A</source>
        <translation>comme A</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>refait&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n diffère</numerusform>
            <numerusform>%n diffèrent</numerusform>
        </translation>
    </message>
    <message>
        <source>Always there</source>
        <translation>Toujours disponible</translation>
    </message>
    <message>
        <source>This place, not this unit</source>
        <translation>Cet emplacement, pas cet appareil</translation>
    </message>
    <message>
        <source>reverted: %1</source>
        <translation>rétabli : %1</translation>
    </message>
</context>
<context>
    <name>mb::TourStage</name>
    <message>
        <source>tour</source>
        <translation>visite</translation>
    </message>
</context>
<context>
    <name>mb::TraceList</name>
    <message>
        <source>Remove the trace</source>
        <translation>Supprimer la courbe</translation>
    </message>
    <message>
        <source>Pane, axis, trigger, reference …</source>
        <translation>Graphique, axe, déclencheur, référence …</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Courbes</translation>
    </message>
</context>
<context>
    <name>mb::TracePanel</name>
    <message>
        <source>Traces</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>fréq.      perdus</translation>
    </message>
    <message>
        <source>mean %1 · σ %2 · %3 … %4 · %5 samples</source>
        <translation>moyenne %1 · σ %2 · %3 … %4 · %5 échantillons</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 perdus</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>dérivé</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 perdus</translation>
    </message>
    <message>
        <source>A %1   B %2</source>
        <translation>A %1   B %2</translation>
    </message>
    <message>
        <source>In a pane of its own</source>
        <translation>Dans son propre graphique</translation>
    </message>
    <message>
        <source>Into the pane above</source>
        <translation>Dans le graphique au-dessus</translation>
    </message>
    <message>
        <source>With its unit</source>
        <translation>Avec la même unité</translation>
    </message>
    <message>
        <source>Scale at the right</source>
        <translation>Échelle à droite</translation>
    </message>
    <message>
        <source>Trigger on it	T</source>
        <translation>Déclencher dessus	T</translation>
    </message>
    <message>
        <source>Keep all as references</source>
        <translation>Garder tout comme références</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Supprimer les références</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spectre</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>Supprimer la courbe</translation>
    </message>
    <message>
        <source>%1 cursors · %2 fits · + − zooms · %3 pauses · N note</source>
        <translation>%1 curseurs · %2 ajuste · + − zoome · %3 fige · N note</translation>
    </message>
    <message>
        <source>%1, of another time</source>
        <translation>%1, d’un autre temps</translation>
    </message>
</context>
<context>
    <name>mb::TrafficView</name>
    <message>
        <source>Columns of %1</source>
        <translation>Colonnes de %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message>
        <source>Which trials</source>
        <translation>Quels essais</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Toutes</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Étoilés</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Propres</translation>
    </message>
    <message>
        <source>Back to best</source>
        <translation>Retour au meilleur</translation>
    </message>
    <message>
        <source>Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing.</source>
        <translation>Met en attente les gains de l’essai propre le plus rapide avec 5 % de dépassement au plus&#x202f;; n’exécute rien.</translation>
    </message>
    <message>
        <source>Export the trials as CSV or JSON</source>
        <translation>Exporter les essais en CSV ou JSON</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Trials of this loop</source>
        <translation>Essais de cette boucle</translation>
    </message>
    <message>
        <source>Every experiment appears here with its gains and what became of it.</source>
        <translation>Chaque expérience apparaît ici avec ses gains et ce qu’elle a donné.</translation>
    </message>
    <message>
        <source>stopped: speed</source>
        <translation>arrêté&#xa0;: vitesse</translation>
    </message>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n, chaque exécution est conservée</numerusform>
            <numerusform>%n, chaque exécution est conservée</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Tous %1</translation>
    </message>
    <message>
        <source>Starred %1</source>
        <translation>Étoilés %1</translation>
    </message>
    <message>
        <source>Clean %1</source>
        <translation>Propres %1</translation>
    </message>
    <message>
        <source>Back to best #%1</source>
        <translation>Retour au meilleur n° %1</translation>
    </message>
    <message>
        <source>Show as B</source>
        <translation>Afficher comme B</translation>
    </message>
    <message>
        <source>Pin as A  A</source>
        <translation>Épingler comme A  A</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>Utiliser ces gains</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>Retirer l’étoile</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Donner une étoile</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Modifier la note</translation>
    </message>
    <message>
        <source>Forget this trial</source>
        <translation>Oublier cet essai</translation>
    </message>
</context>
<context>
    <name>mb::TrialModel</name>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>Retirer l’étoile</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Donner une étoile</translation>
    </message>
    <message>
        <source>Stages the gains of this trial; nothing is written yet.</source>
        <translation>Met en attente les gains de cet essai&#x202f;; rien n’est encore écrit.</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>étoilé</translation>
    </message>
    <message>
        <source>no star</source>
        <translation>sans étoile</translation>
    </message>
    <message>
        <source>Use the gains of trial #%1</source>
        <translation>Utiliser les gains de l’essai n° %1</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>essai</translation>
    </message>
    <message>
        <source>time</source>
        <translation>heure</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>excitation</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>dép. %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>établ.</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>montée</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>pic A</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>marques</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
</context>
<context>
    <name>mb::TrialOrders</name>
    <message>
        <source>the notebook: %1</source>
        <translation>le carnet d’essais&#xa0;: %1</translation>
    </message>
    <message>
        <source>Export trials</source>
        <translation>Exporter les essais</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tableau (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>trials written to %1</source>
        <translation>essais écrits dans %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialWords</name>
    <message>
        <source>better</source>
        <translation>meilleur</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>moins bon</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>plus rapide</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>plus lent</translation>
    </message>
    <message>
        <source>Rise 10–90</source>
        <translation>Montée 10–90</translation>
    </message>
    <message>
        <source>Settle 2 %</source>
        <translation>Établ. 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>Sous-dépassement</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>Erreur statique</translation>
    </message>
    <message>
        <source>IAE</source>
        <translation>IAE</translation>
    </message>
    <message>
        <source>ITAE</source>
        <translation>ITAE</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>Courant de pointe</translation>
    </message>
    <message>
        <source>Duty chatter</source>
        <translation>Agitation cmde</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Saturé</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>Bruit σ</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>Échelon et retour</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Carré</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>PRBS</source>
        <translation>SBPA</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>arrêté&#xa0;: %1</translation>
    </message>
    <message>
        <source>nobody saw its end</source>
        <translation>personne n’a vu sa fin</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 échantillons perdus</translation>
    </message>
    <message>
        <source>saturated %1 %</source>
        <translation>saturé %1 %</translation>
    </message>
</context>
<context>
    <name>mb::TrialsHead</name>
    <message>
        <source>Flip A and B</source>
        <translation>Permuter A et B</translation>
    </message>
    <message>
        <source>Pin B as A</source>
        <translation>Épingler B comme A</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Curseurs A et B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Ajuster temps et valeur</translation>
    </message>
    <message>
        <source>A #%1 is another stimulus, it is not drawn</source>
        <translation>A n° %1 a une autre excitation, il n’est pas tracé</translation>
    </message>
    <message>
        <source>Shift+click on a trial pins it as A</source>
        <translation>Maj+clic sur un essai l’épingle comme A</translation>
    </message>
    <message>
        <source>No trial yet. Run makes the first.</source>
        <translation>Pas encore d’essai. Lancer fait le premier.</translation>
    </message>
</context>
<context>
    <name>mb::TrialsView</name>
    <message>
        <source>Below the plot</source>
        <translation>Sous le graphique</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicateurs</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>non conservé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>mb::TriggerBar</name>
    <message>
        <source>Trigger off</source>
        <translation>Déclencheur désactivé</translation>
    </message>
    <message>
        <source>Arm again: forgets this event, waits for the next</source>
        <translation>Réarmer&#xa0;: oublie cet événement, attend le suivant</translation>
    </message>
    <message>
        <source>Trace that triggers</source>
        <translation>Courbe qui déclenche</translation>
    </message>
    <message>
        <source>↑ rises through</source>
        <translation>↑ passe au-dessus de</translation>
    </message>
    <message>
        <source>↓ falls through</source>
        <translation>↓ passe sous</translation>
    </message>
    <message>
        <source>↕ crosses</source>
        <translation>↕ croise</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>est au-dessus de</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>est sous</translation>
    </message>
    <message>
        <source>Edge or level</source>
        <translation>Front ou niveau</translation>
    </message>
    <message>
        <source>%1 % before</source>
        <translation>%1 % avant</translation>
    </message>
    <message>
        <source>Part of the window before the event</source>
        <translation>Part de la fenêtre avant l’événement</translation>
    </message>
    <message>
        <source>What follows an event</source>
        <translation>Ce qui suit un événement</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Unique</translation>
    </message>
    <message>
        <source>Normal shows every event, single stops at the first</source>
        <translation>Normal montre chaque événement, Unique s’arrête au premier</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>The level; the handle ▸ at the left of the plot drags it, too</source>
        <translation>Le niveau&#x202f;; la poignée ▸ à gauche du graphique le déplace aussi</translation>
    </message>
    <message>
        <source>trigger %1 %2 %3, %4 before</source>
        <translation>déclencheur %1 %2 %3, %4 avant</translation>
    </message>
</context>
<context>
    <name>mb::TuneAxes</name>
    <message>
        <source>%1 %2, at rest</source>
        <comment>mode and target</comment>
        <translation>%1 %2, au repos</translation>
    </message>
    <message>
        <source>axis %1 moves in another mode; stop it first</source>
        <translation>l’axe %1 se déplace dans un autre mode&#x202f;; arrêtez-le d’abord</translation>
    </message>
</context>
<context>
    <name>mb::TuneColumn</name>
    <message>
        <source>The power limit of axis %1 is unknown: its first motion sets it to %2. Write another under Limits of the axis.</source>
        <translation>La limite de puissance de l’axe %1 est inconnue&#xa0;: son premier mouvement la fixe à %2. Écrivez-en une autre sous Limites de l’axe.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
</context>
<context>
    <name>mb::TuneCommands</name>
    <message>
        <source>Stop motion</source>
        <translation>Arrêter le mouvement</translation>
    </message>
    <message>
        <source>Ends the motion and stays armed. STOP, Esc and Pause stop everything.</source>
        <translation>Met fin au mouvement et reste armé. STOP, Esc et Pause arrêtent tout.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Write and run</source>
        <translation>Écrire et lancer</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Run %1 axes</source>
        <translation>Lancer %1 axes</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Expérience</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>Stop axis %1</source>
        <translation>Arrêter l’axe %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneExperiments</name>
    <message>
        <source>Experiment</source>
        <translation>Expérience</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Stop the motion before an experiment.</source>
        <translation>Arrêtez le mouvement avant une expérience.</translation>
    </message>
    <message>
        <source>The stimulus cannot be sent</source>
        <translation>L’excitation ne peut pas être envoyée</translation>
    </message>
    <message>
        <source>No experiment yet</source>
        <translation>Pas encore d’expérience possible</translation>
    </message>
    <message>
        <source>No experiment in this mode</source>
        <translation>Pas d’expérience dans ce mode</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Non armé</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Maintenez le bouton Armer pendant 1 s pour armer %1.</translation>
    </message>
    <message>
        <source>The position of axis %1 is not known yet</source>
        <translation>La position de l’axe %1 n’est pas encore connue</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>aucun appareil</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>sa position n’est pas encore connue</translation>
    </message>
    <message>
        <source>Run begins the experiment.</source>
        <translation>Lancer commence l’expérience.</translation>
    </message>
</context>
<context>
    <name>mb::TuneForm</name>
    <message>
        <source>the running slot</source>
        <translation>le jeu actif</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>un sens ou une limite</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>le mode</translation>
    </message>
</context>
<context>
    <name>mb::TuneFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Partie de la page</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Préparation</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicateurs</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
</context>
<context>
    <name>mb::TuneGains</name>
    <message>
        <source>A gain is out of range</source>
        <translation>Un gain est hors plage</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>Corrigez-le ou rétablissez-le d’abord.</translation>
    </message>
    <message>
        <source>Look at a gain again</source>
        <translation>Revoir un gain</translation>
    </message>
    <message>
        <source>Writing gains</source>
        <translation>Écriture des gains</translation>
    </message>
    <message>
        <source>Reading gains</source>
        <translation>Lecture des gains</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>gains not written: %1</source>
        <translation>gains non écrits&#xa0;: %1</translation>
    </message>
    <message>
        <source>Gains of trial #%1</source>
        <translation>Gains de l’essai n° %1</translation>
    </message>
    <message>
        <source>What the adviser proposes</source>
        <translation>Ce que propose le conseiller</translation>
    </message>
    <message>
        <source>nothing copied: no gain of axis %1 is known for this mode; write it first</source>
        <translation>rien copié&#xa0;: aucun gain de l’axe %1 n’est connu pour ce mode&#x202f;; écrivez-le d’abord</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Gains et limites de l’axe %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneKeys</name>
    <message>
        <source>writes what is staged and runs</source>
        <translation>écrit ce qui est en attente et lance</translation>
    </message>
    <message>
        <source>the same, four times over</source>
        <translation>la même chose, quatre fois de suite</translation>
    </message>
    <message>
        <source>a battery of steps: several sizes, both ways, and the worst of them</source>
        <translation>une série d’échelons&#xa0;: plusieurs amplitudes, les deux sens, et le pire d’entre eux</translation>
    </message>
    <message>
        <source>goes to the first gain</source>
        <translation>va au premier gain</translation>
    </message>
    <message>
        <source>swaps the gain slots; disarms</source>
        <translation>permute les jeux de gains&#x202f;; désarme</translation>
    </message>
    <message>
        <source>flips trials A and B</source>
        <translation>permute les essais A et B</translation>
    </message>
    <message>
        <source>pins trial B as A</source>
        <translation>épingle l’essai B comme A</translation>
    </message>
    <message>
        <source>cursors in the plot: arrows move one, C changes to the other</source>
        <translation>curseurs dans la courbe&#xa0;: les flèches en déplacent un, C passe à l’autre</translation>
    </message>
    <message>
        <source>fits time and value of the plot</source>
        <translation>ajuste temps et valeur de la courbe</translation>
    </message>
    <message>
        <source>pauses the live view, and goes on</source>
        <translation>fige la vue en direct, puis la reprend</translation>
    </message>
    <message>
        <source>identifies the device: it blinks</source>
        <translation>identifie l’appareil&#xa0;: il clignote</translation>
    </message>
    <message>
        <source>undoes the last edit of gains, or else the last write to the unit</source>
        <translation>annule la dernière modification des gains, sinon la dernière écriture dans l’appareil</translation>
    </message>
    <message>
        <source>writes a report of the trials that are shown</source>
        <translation>écrit un rapport des essais affichés</translation>
    </message>
    <message>
        <source>held: moves the armed motor gently forwards or backwards</source>
        <translation>maintenu&#xa0;: déplace doucement le moteur armé en avant ou en arrière</translation>
    </message>
    <message>
        <source>on a gain&apos;s slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %</source>
        <translation>sur le curseur d’un gain&#xa0;: 2 %, avec Maj 0,2 %, avec Ctrl 20 %&#x202f;; la molette fait de même par 2 %</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>rétablit la dernière modification ou écriture</translation>
    </message>
</context>
<context>
    <name>mb::TuneMotion</name>
    <message>
        <source>position 0 is here; the motor is off until Run</source>
        <translation>la position 0 est ici&#x202f;; le moteur est coupé jusqu’à Lancer</translation>
    </message>
    <message>
        <source>it has no lamp that could blink</source>
        <translation>il n’a pas de voyant qui puisse clignoter</translation>
    </message>
    <message>
        <source>not identified: %1</source>
        <translation>non identifié&#xa0;: %1</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>désarmé&#xa0;: %1 a changé</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Non armé</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Maintenez le bouton Armer pendant 1 s pour armer %1.</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>axe %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1, jeu %2</translation>
    </message>
    <message>
        <source> · also moving: axis %1</source>
        <translation> · aussi en mouvement&#xa0;: axe %1</translation>
    </message>
    <message>
        <source>Its position is not known yet</source>
        <translation>Sa position n’est pas encore connue</translation>
    </message>
    <message>
        <source>It starts where it is once it has told where that is.</source>
        <translation>Il part d’où il est, dès qu’il a dit où c’est.</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1&#x202f;: maintient</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>Run begins %1</source>
        <translation>Lancer commence %1</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
    <message>
        <source>disarmed: another device is selected</source>
        <translation>désarmé&#xa0;: un autre appareil est sélectionné</translation>
    </message>
    <message>
        <source>%1 is in its bootloader</source>
        <translation>%1 est dans son bootloader</translation>
    </message>
    <message>
        <source>It cannot drive a motor until it has firmware. Write an image on the Firmware page.</source>
        <translation>Il ne peut pas piloter de moteur sans firmware. Écrivez une image dans la page Firmware.</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Sélectionnez un appareil</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Pas encore d’appareil</translation>
    </message>
    <message>
        <source>Choose one in the list at the left; its loop is tuned here.</source>
        <translation>Choisissez-en un dans la liste à gauche&#x202f;; sa boucle se règle ici.</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu, to drive a motor.</source>
        <translation>Ouvrez une liaison, ou le banc simulé depuis le menu, pour piloter un moteur.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Aucun appareil</translation>
    </message>
    <message>
        <source>No answer from %1</source>
        <translation>Pas de réponse de %1</translation>
    </message>
    <message>
        <source>The plot keeps what it has.</source>
        <translation>La courbe garde ce qu’elle a.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Arrêté&#xa0;: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Maintenez le bouton Armer pendant 1 s pour réarmer.</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 ne peut pas être armé</translation>
    </message>
    <message>
        <source>The set-point cannot be sent</source>
        <translation>La consigne ne peut pas être envoyée</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>Quelque chose bouge</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm it first.</source>
        <translation>Maintenez d’abord le bouton Armer pendant 1 s pour l’armer.</translation>
    </message>
    <message>
        <source>not run: %1. %2</source>
        <translation>non lancé&#xa0;: %1. %2</translation>
    </message>
</context>
<context>
    <name>mb::TunePlot</name>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>tr/min</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Incréments par tour</translation>
    </message>
    <message>
        <source>Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and gains in physical units.</source>
        <translation>Incréments du codeur pour un tour d’arbre, quatre par trait. Sert aux tr/min, aux degrés et aux gains en unités physiques.</translation>
    </message>
    <message>
        <source>counts/rev</source>
        <translation>counts/tr</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>%1 dernières s</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Durée de l’axe du temps</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>Figer la vue</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Curseurs A et B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Ajuster temps et valeur</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>courbe écrite dans %1</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>ch%1 set-point</source>
        <translation>ch%1 consigne</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DÉMO</translation>
    </message>
</context>
<context>
    <name>mb::TuneSteps</name>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Limites</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Modèle</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Gains</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>The direction of motor and encoder was checked; the first closed loop of a run checks it again.</source>
        <translation>Le sens du moteur et du codeur a été vérifié ; la première boucle fermée d’une exécution le vérifie encore.</translation>
    </message>
    <message>
        <source>Checked by itself before the first closed loop of a run.</source>
        <translation>Vérifié tout seul avant la première boucle fermée d’une exécution.</translation>
    </message>
    <message>
        <source>Every limit of an experiment is known.</source>
        <translation>Toutes les limites d’un essai sont connues.</translation>
    </message>
    <message>
        <source>Trial #%1 pushed the motor without a loop.</source>
        <translation>L’essai nº %1 a poussé le moteur sans boucle.</translation>
    </message>
    <message>
        <source>The device has the gains that are shown.</source>
        <translation>L’appareil a les gains affichés.</translation>
    </message>
    <message>
        <source>Edited gains wait to be written.</source>
        <translation>Les gains modifiés attendent d’être écrits.</translation>
    </message>
    <message>
        <source>The gains of the device are not known yet.</source>
        <translation>Les gains de l’appareil ne sont pas encore connus.</translation>
    </message>
    <message>
        <source>Trial #%1 ran with these gains.</source>
        <translation>L’essai nº %1 a tourné avec ces gains.</translation>
    </message>
    <message>
        <source>The gains are in flash.</source>
        <translation>Les gains sont en flash.</translation>
    </message>
    <message>
        <source>The gains are not known to be in flash.</source>
        <translation>On ne sait pas si les gains sont en flash.</translation>
    </message>
    <message>
        <source>%1: done</source>
        <comment>step</comment>
        <translation>%1 : fait</translation>
    </message>
    <message>
        <source>Steps; next is %1</source>
        <translation>Étapes ; la suivante est %1</translation>
    </message>
    <message>
        <source>Steps; all are done</source>
        <translation>Étapes ; toutes sont faites</translation>
    </message>
    <message>
        <source>The last check found it wrong: the encoder is reversed, or the motor did not move.</source>
        <translation>Le dernier contrôle l’a trouvée fausse : le codeur est inversé, ou le moteur n’a pas bougé.</translation>
    </message>
    <message>
        <source>No model of the motor yet: the page Design identifies it.</source>
        <translation>Pas encore de modèle du moteur : la page Conception l’identifie.</translation>
    </message>
    <message>
        <source>No trial with these gains yet: Run makes one.</source>
        <translation>Pas encore d’essai avec ces gains : Lancer en fait un.</translation>
    </message>
</context>
<context>
    <name>mb::TuningSteps</name>
    <message>
        <source>Kept</source>
        <translation>Conservé</translation>
    </message>
    <message>
        <source>Proposed, nothing written</source>
        <translation>Proposé, rien n’est écrit</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Annulé, état rétabli</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Refusé</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Ce qui se passe</translation>
    </message>
    <message>
        <source>Working: the motor turns</source>
        <translation>En cours&#xa0;: le moteur tourne</translation>
    </message>
    <message>
        <source>STOP ends it at any moment; what was changed is put back.</source>
        <translation>STOP y met fin à tout moment&#x202f;; ce qui a été modifié est rétabli.</translation>
    </message>
    <message>
        <source>Nothing has moved yet</source>
        <translation>Rien n’a encore bougé</translation>
    </message>
    <message>
        <source>over ≤ %1 %, settle ≤ %2, error ≤ %3 %</source>
        <translation>dép. ≤ %1 %, établt ≤ %2, erreur ≤ %3 %</translation>
    </message>
    <message>
        <source>over ≤ %1 %, error ≤ %2 %</source>
        <translation>dép. ≤ %1 %, erreur ≤ %2 %</translation>
    </message>
    <message>
        <source>over %1 %, settle %2, error %3 %</source>
        <translation>dép. %1 %, établt %2, erreur %3 %</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Identifier le moteur</translation>
    </message>
    <message>
        <source>Pushes with a part of the duty, both ways. No gain is changed.</source>
        <translation>Pousse avec une partie du rapport cyclique, dans les deux sens. Aucun gain n’est modifié.</translation>
    </message>
    <message>
        <source>Choose a set</source>
        <translation>Choisir un jeu</translation>
    </message>
    <message>
        <source>The plots show what each would do.</source>
        <translation>Les courbes montrent l’effet de chacun.</translation>
    </message>
    <message>
        <source>Write and prove it</source>
        <translation>L’écrire et le vérifier</translation>
    </message>
    <message>
        <source>The gains are written, steps both ways are measured.</source>
        <translation>Les gains sont écrits, des échelons dans les deux sens sont mesurés.</translation>
    </message>
    <message>
        <source>Keep it, or put everything back</source>
        <translation>Le garder, ou tout rétablir</translation>
    </message>
    <message>
        <source>It stays if it does what was predicted; else the reason is said.</source>
        <translation>Il reste s’il fait ce qui était prédit ; sinon la raison est indiquée.</translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>Écrire %1 dans le jeu %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Écrire %1</translation>
    </message>
    <message>
        <source>The slot that the result is not for; what it had comes back.</source>
        <translation>Le jeu auquel le résultat n’est pas destiné ; son contenu revient.</translation>
    </message>
    <message>
        <source>What is replaced is kept, to be put back.</source>
        <translation>Ce qui est remplacé est gardé, pour être rétabli.</translation>
    </message>
    <message>
        <source>Run %1 steps of %2 %3</source>
        <translation>Exécuter %1 échelons de %2 %3</translation>
    </message>
    <message>
        <source>Both ways, every guard on; each is a trial.</source>
        <translation>Dans les deux sens, toutes les gardes actives ; chacun est un essai.</translation>
    </message>
    <message>
        <source>Keep it in slot %1 when all hold</source>
        <translation>Le garder dans le jeu %1 si tout tient</translation>
    </message>
    <message>
        <source>Keep it when all hold</source>
        <translation>Le garder si tout tient</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>mesuré : %1</translation>
    </message>
    <message>
        <source>Else put everything back</source>
        <translation>Sinon tout rétablir</translation>
    </message>
    <message>
        <source>Gains as before, the reason in the log.</source>
        <translation>Gains comme avant, la raison dans le journal.</translation>
    </message>
    <message>
        <source>motor turns %1 s</source>
        <translation>le moteur tourne %1 s</translation>
    </message>
    <message>
        <source>Identify and Autotune push first: %1</source>
        <translation>Identifier et Autoréglage poussent d’abord : %1</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>Non conservé</translation>
    </message>
    <message>
        <source>Find the gains anew</source>
        <translation>Chercher à nouveau les gains</translation>
    </message>
    <message>
        <source>Those that are shown were found for other limits, or elsewhere.</source>
        <translation>Ceux qui sont affichés ont été trouvés pour d’autres limites, ou ailleurs.</translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message>
        <source>no unit answers yet</source>
        <translation>aucun appareil ne répond encore</translation>
    </message>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n appareil répond</numerusform>
            <numerusform>%n appareils répondent, un à la fois</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 may turn</source>
        <translation>%1 tourne peut-être</translation>
    </message>
    <message>
        <source>no motor turns</source>
        <translation>aucun moteur ne tourne</translation>
    </message>
    <message>
        <source>no link is open</source>
        <translation>aucune liaison n’est ouverte</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 est ouvert</translation>
    </message>
    <message>
        <source>the journal takes entries</source>
        <translation>le journal prend les entrées</translation>
    </message>
    <message>
        <source>the journal keeps entries on this computer</source>
        <translation>le journal garde les entrées sur cet ordinateur</translation>
    </message>
    <message>
        <source>Before each unit</source>
        <translation>Avant chaque appareil</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 n’est pas ouvert</translation>
    </message>
</context>
<context>
    <name>mb::UnitList</name>
    <message>
        <source>Last ten units, newest first</source>
        <translation>Dix derniers appareils, le plus récent en premier</translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message>
        <source>Device, now</source>
        <translation>Appareil, maintenant</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>réglages d’usine</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en direct</translation>
    </message>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n valeur</numerusform>
            <numerusform>%n valeurs</numerusform>
        </translation>
    </message>
    <message>
        <source>by hand, %1</source>
        <translation>à la main, %1</translation>
    </message>
    <message>
        <source>automatic, %1</source>
        <translation>automatique, %1</translation>
    </message>
    <message>
        <source>from the device description</source>
        <translation>de la description de l’appareil</translation>
    </message>
</context>
<context>
    <name>mb::UnitSteps</name>
    <message>
        <source>Steps of this unit</source>
        <translation>Étapes de cet appareil</translation>
    </message>
    <message>
        <source>Skip this unit</source>
        <translation>Sauter cet appareil</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Refaire</translation>
    </message>
    <message>
        <source>No unit selected</source>
        <translation>Aucun appareil sélectionné</translation>
    </message>
</context>
<context>
    <name>mb::UnitUpdate</name>
    <message>
        <source>Verified: %1</source>
        <translation>Vérifié&#xa0;: %1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>Inutile&#xa0;: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Refusé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échec&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancelled. %1.</source>
        <translation>Annulé. %1.</translation>
    </message>
    <message>
        <source>device</source>
        <translation>appareil</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>image</source>
        <translation>image</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Ouvrir une image…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Progress of the update</source>
        <translation>Progression de la mise à jour</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Mettre à jour</translation>
    </message>
    <message>
        <source>Run the update again</source>
        <translation>Relancer la mise à jour</translation>
    </message>
    <message>
        <source>One update a bus: %1 is being written.</source>
        <translation>Une seule mise à jour par bus&#xa0;: écriture de %1 en cours.</translation>
    </message>
    <message>
        <source>no device selected</source>
        <translation>aucun appareil sélectionné</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>image fits this family</source>
        <translation>image adaptée à cette famille</translation>
    </message>
    <message>
        <source>no usable image</source>
        <translation>aucune image utilisable</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>le moteur est en mouvement</translation>
    </message>
    <message>
        <source>motor stopped</source>
        <translation>moteur à l’arrêt</translation>
    </message>
    <message>
        <source>no other master, number unique</source>
        <translation>pas d’autre maître, numéro unique</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>autre maître, ou numéro pris deux fois</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>aucun appareil</translation>
    </message>
    <message>
        <source>%1 s a page, about %2 s left</source>
        <translation>%1 s par page, encore %2 s environ</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Rien en cours</translation>
    </message>
    <message>
        <source>%1, %2 of %3 written</source>
        <translation>%1, %2 sur %3 écrites</translation>
    </message>
    <message>
        <source>%1 s, pages sent again: %2</source>
        <translation>%1 s, pages renvoyées&#xa0;: %2</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>Ouvrir une image de firmware</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>motor not known</source>
        <translation>moteur inconnu</translation>
    </message>
    <message>
        <source>Cancelled: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Annulé&#xa0;: rien n’a été écrit.</translation>
    </message>
    <message>
        <source>%1, as in the image</source>
        <translation>%1, comme dans l’image</translation>
    </message>
    <message>
        <source>Written, not proved: %1</source>
        <translation>Écrit, non prouvé : %1</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened and is read again; start the update once more</source>
        <translation>%1 a changé depuis son ouverture et a été relu ; relancez la mise à jour</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Avant de démarrer</translation>
    </message>
    <message>
        <source>Units are served on this link.</source>
        <translation>Des appareils sont en cours de traitement sur cette liaison.</translation>
    </message>
</context>
<context>
    <name>mb::UpdateLog</name>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Sauvegarder le journal…</translation>
    </message>
    <message>
        <source>Log of the update</source>
        <translation>Journal de la mise à jour</translation>
    </message>
    <message>
        <source>Save the log of the update</source>
        <translation>Sauvegarder le journal de la mise à jour</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Texte (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::UpdateSide</name>
    <message>
        <source>Flash pages</source>
        <translation>Pages de flash</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>Dans l’ordre d’écriture. Vert&#xa0;: écrite. Bord orange&#xa0;: renvoyée. Tirets&#xa0;: absente de l’image. Rouge&#xa0;: ne pas interrompre.</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>Ne pas débrancher</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Débranchement autorisé</translation>
    </message>
    <message>
        <source>Nothing is written now</source>
        <translation>Aucune écriture en cours</translation>
    </message>
    <message>
        <source>The motor turns as soon as Arm in the header is held.</source>
        <translation>Le moteur tourne dès que Armer est maintenu dans l’en-tête.</translation>
    </message>
    <message>
        <source>The self-test turns the motor.</source>
        <translation>L’autotest fait tourner le moteur.</translation>
    </message>
</context>
<context>
    <name>mb::VerdictView</name>
    <message>
        <source>READY</source>
        <translation>PRÊT</translation>
    </message>
    <message>
        <source>WORKING</source>
        <translation>EN COURS</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>RÉUSSI</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>ÉCHEC</translation>
    </message>
    <message>
        <source>REFUSED</source>
        <translation>REFUSÉ</translation>
    </message>
    <message>
        <source>LEFT OUT</source>
        <translation>OMIS</translation>
    </message>
</context>
<context>
    <name>mb::Welcome</name>
    <message>
        <source>Folder with firmware</source>
        <translation>Dossier des firmwares</translation>
    </message>
</context>
<context>
    <name>mb::WindowKeys</name>
    <message>
        <source>shows these keys; once more, the help for this page</source>
        <translation>affiche ces touches&#x202f;; encore une fois, l’aide de cette page</translation>
    </message>
    <message>
        <source>production: unit after unit, full screen; and back</source>
        <translation>production&#xa0;: appareil après appareil, plein écran&#x202f;; et retour</translation>
    </message>
    <message>
        <source>shows page %1</source>
        <translation>affiche la page %1</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menu</translation>
    </message>
    <message>
        <source>renames the selected device; in production: goes to the serial number</source>
        <translation>renomme l’appareil sélectionné ; en production : va au numéro de série</translation>
    </message>
    <message>
        <source>stores what the selected device has in RAM only</source>
        <translation>mémorise ce que l’appareil sélectionné n’a qu’en RAM</translation>
    </message>
    <message>
        <source>takes a snapshot of the selected device</source>
        <translation>prend un instantané de l’appareil sélectionné</translation>
    </message>
</context>
<context>
    <name>mb::WindowMenu</name>
    <message>
        <source>Add link…</source>
        <translation>Ajouter une liaison…</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Ouvrir le banc simulé</translation>
    </message>
    <message>
        <source>Open the folder of a machine…</source>
        <translation>Ouvrir le dossier d’une machine…</translation>
    </message>
    <message>
        <source>Save the machine into a folder…</source>
        <translation>Sauvegarder la machine dans un dossier…</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Commandes…</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>Basculer entre sombre et clair</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>Préférences…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>About MotorBench</source>
        <translation>À propos de MotorBench</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>All recordings (*.log *.asc *.txt *.mcap *.csv)</source>
        <translation>Tous les enregistrements (*.log *.asc *.txt *.mcap *.csv)</translation>
    </message>
    <message>
        <source>Frames: candump and Vector ASC logs (*.log *.asc *.txt)</source>
        <translation>Trames&#xa0;: journaux candump et Vector ASC (*.log *.asc *.txt)</translation>
    </message>
    <message>
        <source>Samples: MCAP, CSV (*.mcap *.csv)</source>
        <translation>Échantillons&#xa0;: MCAP, CSV (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>lists everything that can be done, by name</source>
        <translation>liste tout ce qui peut être fait, par nom</translation>
    </message>
    <message>
        <source>shows the preferences</source>
        <translation>affiche les préférences</translation>
    </message>
    <message>
        <source>switches between dark and light</source>
        <translation>bascule entre sombre et clair</translation>
    </message>
    <message>
        <source>opens a recording</source>
        <translation>ouvre un enregistrement</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>quitte le programme</translation>
    </message>
</context>
<context>
    <name>table</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Courant</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Rapport cyclique</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>F: the firmware&apos;s codes</source>
        <translation>F&#xa0;: codes du firmware</translation>
    </message>
    <message>
        <source>A unit that speaks the document&apos;s codes would take position for current and current for position.</source>
        <translation>Un appareil qui parle les codes du document prendrait la position pour le courant et le courant pour la position.</translation>
    </message>
    <message>
        <source>L: legacy frames of 8 bytes</source>
        <translation>L&#xa0;: anciennes trames de 8 octets</translation>
    </message>
    <message>
        <source>A unit with today&apos;s firmware ignores these frames, the stop excepted, which is sent both ways.</source>
        <translation>Un appareil au firmware actuel ignore ces trames, sauf l’arrêt, qui est envoyé des deux façons.</translation>
    </message>
    <message>
        <source>LL: older, cannot be stopped</source>
        <translation>LL&#xa0;: plus ancien, arrêt impossible</translation>
    </message>
    <message>
        <source>It is only watched: there is no code that stops it.</source>
        <translation>Il est seulement observé&#xa0;: aucun code ne l’arrête.</translation>
    </message>
    <message>
        <source>D: the document&apos;s codes</source>
        <translation>D&#xa0;: codes du document</translation>
    </message>
    <message>
        <source>A unit that speaks the firmware&apos;s codes runs at full power when it is told a position, and loses its divisor when D is written.</source>
        <translation>Un appareil qui parle les codes du firmware tourne à pleine puissance quand on lui donne une position, et perd son diviseur quand D est écrit.</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Incréments par tour</translation>
    </message>
    <message>
        <source>Encoder edges in one turn: four times its lines.</source>
        <translation>Fronts du codeur par tour&#xa0;: quatre fois ses traits.</translation>
    </message>
    <message>
        <source>Ampere per count</source>
        <translation>Ampères par count</translation>
    </message>
    <message>
        <source>What one count of the current converter stands for; it depends on the board.</source>
        <translation>Ce que vaut un count du convertisseur de courant&#x202f;; dépend de la carte.</translation>
    </message>
    <message>
        <source>Degrees per count</source>
        <translation>Degrés par count</translation>
    </message>
    <message>
        <source>What one count of the temperature converter stands for; it depends on the board.</source>
        <translation>Ce que vaut un count du convertisseur de température&#x202f;; dépend de la carte.</translation>
    </message>
    <message>
        <source>Nothing is written yet; the update can be run again</source>
        <translation>Rien n’est encore écrit&#x202f;; la mise à jour peut être relancée</translation>
    </message>
    <message>
        <source>The flash is being written: it must not be cut</source>
        <translation>Écriture de la flash en cours&#xa0;: ne pas interrompre</translation>
    </message>
    <message>
        <source>A unit that is cut while it is written holds half a program. It runs again once an update has succeeded.</source>
        <translation>Un appareil interrompu pendant l’écriture contient un demi-programme. Il tournera à nouveau dès qu’une mise à jour aura réussi.</translation>
    </message>
    <message>
        <source>output saturated</source>
        <translation>sortie saturée</translation>
    </message>
    <message>
        <source>output wrapped around</source>
        <translation>débordement de la sortie</translation>
    </message>
    <message>
        <source>count/s</source>
        <translation>count/s</translation>
    </message>
    <message>
        <source>ADC count</source>
        <translation>count ADC</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>OpenOCD finds no debug probe</source>
        <translation>OpenOCD ne trouve aucune sonde de débogage</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after openocd:</source>
        <translation>branchez-la, et vérifiez que son type est celui indiqué après openocd:</translation>
    </message>
    <message>
        <source>OpenOCD has no interface of this name</source>
        <translation>OpenOCD n’a pas d’interface de ce nom</translation>
    </message>
    <message>
        <source>name one of its interface files, such as openocd:stlink</source>
        <translation>nommez l’un de ses fichiers d’interface, par exemple openocd:stlink</translation>
    </message>
    <message>
        <source>this interface does not speak SWD</source>
        <translation>cette interface ne parle pas SWD</translation>
    </message>
    <message>
        <source>name a debug probe that does, such as openocd:stlink</source>
        <translation>nommez une sonde de débogage qui le fait, par exemple openocd:stlink</translation>
    </message>
    <message>
        <source>the microcontroller does not hold what was written</source>
        <translation>le microcontrôleur ne contient pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>run it again with shorter wires or a lower speed</source>
        <translation>relancez avec des fils plus courts ou une vitesse plus faible</translation>
    </message>
    <message>
        <source>the microcontroller refused to be written</source>
        <translation>le microcontrôleur a refusé l’écriture</translation>
    </message>
    <message>
        <source>it may be protected, or be another kind than --target says</source>
        <translation>il est peut-être protégé, ou d’un autre type que ne le dit --target</translation>
    </message>
    <message>
        <source>the microcontroller is another kind than --target says</source>
        <translation>le microcontrôleur est d’un autre type que ne le dit --target</translation>
    </message>
    <message>
        <source>choose the other one of f1 and f4</source>
        <translation>choisissez l’autre entre f1 et f4</translation>
    </message>
    <message>
        <source>the probe is there, but no microcontroller answers it</source>
        <translation>la sonde est là, mais aucun microcontrôleur ne lui répond</translation>
    </message>
    <message>
        <source>check SWDIO, SWCLK, ground and the power of the drive</source>
        <translation>vérifiez SWDIO, SWCLK, la masse et l’alimentation du variateur</translation>
    </message>
    <message>
        <source>the microcontroller could not be halted</source>
        <translation>le microcontrôleur n’a pas pu être stoppé</translation>
    </message>
    <message>
        <source>check the reset wire and the power of the drive</source>
        <translation>vérifiez le fil de reset et l’alimentation du variateur</translation>
    </message>
    <message>
        <source>the debug probe is there but may not be opened</source>
        <translation>la sonde de débogage est là mais ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>install OpenOCD&apos;s udev rules or ask your administrator</source>
        <translation>installez les règles udev d’OpenOCD ou demandez à votre administrateur</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>Boucle de vitesse</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>Boucle de courant</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>Boucle de position</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>Diviseur</translation>
    </message>
    <message>
        <source>Output (255 = 100 %) per unit of error, times the divisor. Above 32767 the output wraps to full reverse: the program keeps set-points close enough to the motor for that.</source>
        <translation>Sortie (255 = 100 %) par unité d’erreur, multipliée par le diviseur. Au-dessus de 32767, la sortie bascule à fond en arrière&#xa0;: le programme garde pour cela les consignes assez près du moteur.</translation>
    </message>
    <message>
        <source>Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so small gains do nothing, and nothing limits the sum.</source>
        <translation>Sortie par unité d’erreur et milliseconde, multipliée par le diviseur. Chaque pas de 20 ms est tronqué à un entier, donc les petits gains ne font rien, et rien ne limite la somme.</translation>
    </message>
    <message>
        <source>Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only negative numbers damp.</source>
        <translation>Sortie multipliée par des millisecondes par variation d’erreur, multipliée par le diviseur. Son signe est inversé dans le variateur&#xa0;: seuls les nombres négatifs amortissent.</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Moyennage</translation>
    </message>
    <message>
        <source>Loop error</source>
        <translation>Erreur de boucle</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Alimentation</translation>
    </message>
    <message>
        <source>Analog input</source>
        <translation>Entrée analogique</translation>
    </message>
    <message>
        <source>count/100&#xa0;ms</source>
        <translation>count/100 ms</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>cycle</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>surintensité</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>surchauffe</translation>
    </message>
    <message>
        <source>under-voltage</source>
        <translation>sous-tension</translation>
    </message>
    <message>
        <source>gate driver</source>
        <translation>driver de grille</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>communication</translation>
    </message>
    <message>
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>L’appareil attend ensuite dans son bootloader&#x202f;; la mise à jour peut être relancée</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>Écriture de la page 0 en cours&#xa0;: ne pas interrompre</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>Un appareil interrompu reste dans son bootloader et peut être remis à jour. Seule la page 0, la dernière, ne doit pas être interrompue.</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>La page 0 contient le vecteur de reset. Une interruption maintenant ne peut pas être réparée par le bus.</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Fins de course</translation>
    </message>
    <message>
        <source>Soft limits</source>
        <translation>Limites logicielles</translation>
    </message>
    <message>
        <source>Loop, slot 0</source>
        <translation>Boucle, jeu 0</translation>
    </message>
    <message>
        <source>Loop, slot 1</source>
        <translation>Boucle, jeu 1</translation>
    </message>
    <message>
        <source>Current limiter</source>
        <translation>Limiteur de courant</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Codeur</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Défauts</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Limite de courant</translation>
    </message>
    <message>
        <source>Status frames</source>
        <translation>Trames d’état</translation>
    </message>
    <message>
        <source>Normally closed is hit when the switch opens, normally open when it closes. A hit blocks output in this direction.</source>
        <translation>Un contact NF agit quand il s’ouvre, un contact NO quand il se ferme. La sortie est alors bloquée dans ce sens.</translation>
    </message>
    <message>
        <source>On switches the limit OFF: the sense is the opposite of the soft limits&apos; Enabled.</source>
        <translation>Marche DÉSACTIVE la limite&#xa0;: l’inverse de «&#xa0;activée&#xa0;» des limites logicielles.</translation>
    </message>
    <message>
        <source>Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.</source>
        <translation>Sortie (32767 = 100 %) par unité d’erreur&#xa0;: counts/100 ms, counts ou A, selon le mode.</translation>
    </message>
    <message>
        <source>Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.</source>
        <translation>Sortie par unité d’erreur et cycle de 500 µs. Avec F·K = 1, tout I dépasse.</translation>
    </message>
    <message>
        <source>Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.</source>
        <translation>Sortie par variation d’erreur en un cycle de 500 µs. Un incrément de bruit fait un pic de D.</translation>
    </message>
    <message>
        <source>Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.</source>
        <translation>Borne de l’accumulateur intégral, entier brut. 0 signifie illimité, pas zéro.</translation>
    </message>
    <message>
        <source>Output per unit of set-point, added to P, I and D.</source>
        <translation>Sortie par unité de consigne, ajoutée à P, I et D.</translation>
    </message>
    <message>
        <source>Below it P, I and D contribute nothing and the integral is cleared; F still applies. 0 switches the feature off.</source>
        <translation>En dessous, P, I et D ne contribuent pas et l’intégrale est effacée&#x202f;; F agit toujours. 0 désactive la fonction.</translation>
    </message>
    <message>
        <source>Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 %. Lower is slower, but 0 is no ramp.</source>
        <translation>Variation maximale de la sortie par cycle de 500 µs&#x202f;; 16 met 1,024 s de 0 à 100 %. Plus petit est plus lent, mais 0 est sans rampe.</translation>
    </message>
    <message>
        <source>Greatest forward output, 32767 = 100 %.</source>
        <translation>Sortie maximale en avant, 32767 = 100 %.</translation>
    </message>
    <message>
        <source>Greatest reverse output, −32768 = −100 %. A number at or below 0.</source>
        <translation>Sortie maximale en arrière, −32768 = −100 %. Un nombre inférieur ou égal à 0.</translation>
    </message>
    <message>
        <source>Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.</source>
        <translation>Sortie minimale en avant hors de l’erreur admissible&#x202f;; vainc le frottement. Boucle fermée seulement.</translation>
    </message>
    <message>
        <source>Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.</source>
        <translation>Sortie minimale en arrière hors de l’erreur admissible, inférieure ou égale à 0. Boucle fermée seulement.</translation>
    </message>
    <message>
        <source>Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.</source>
        <translation>Remet à zéro tant que le contact est actif, même si sa limite est désactivée. Perdu à la mise hors tension.</translation>
    </message>
    <message>
        <source>Writing anything but 0 reads the count and clears it.</source>
        <translation>Écrire autre chose que 0 lit le compteur et l’efface.</translation>
    </message>
    <message>
        <source>Forward switch is normally closed</source>
        <translation>Contact avant NF</translation>
    </message>
    <message>
        <source>Forward switch disabled</source>
        <translation>Contact avant désactivé</translation>
    </message>
    <message>
        <source>Reverse switch is normally closed</source>
        <translation>Contact arrière NF</translation>
    </message>
    <message>
        <source>Reverse switch disabled</source>
        <translation>Contact arrière désactivé</translation>
    </message>
    <message>
        <source>Forward soft limit</source>
        <translation>Limite log. avant</translation>
    </message>
    <message>
        <source>At or above this position forward output is blocked, if enabled.</source>
        <translation>À partir de cette position, la sortie en avant est bloquée, si activée.</translation>
    </message>
    <message>
        <source>Forward soft limit enabled</source>
        <translation>Limite log. avant activée</translation>
    </message>
    <message>
        <source>On switches the limit ON: the sense is the opposite of the switches&apos; Disabled.</source>
        <translation>Marche ACTIVE la limite&#xa0;: l’inverse de «&#xa0;désactivé&#xa0;» des contacts.</translation>
    </message>
    <message>
        <source>Reverse soft limit</source>
        <translation>Limite log. arrière</translation>
    </message>
    <message>
        <source>At or below this position reverse output is blocked, if enabled.</source>
        <translation>Jusqu’à cette position, la sortie en arrière est bloquée, si activée.</translation>
    </message>
    <message>
        <source>Reverse soft limit enabled</source>
        <translation>Limite log. arrière activée</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>Échelle de courant</translation>
    </message>
    <message>
        <source>Calibrated at the factory. All current limiting depends on it: change it only to trim the reading.</source>
        <translation>Étalonné en usine. Toute la limitation de courant en dépend&#xa0;: ne le modifiez que pour ajuster la mesure.</translation>
    </message>
    <message>
        <source>I zone</source>
        <translation>Zone I</translation>
    </message>
    <message>
        <source>Allowable error</source>
        <translation>Erreur admissible</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Maximum forward</source>
        <translation>Maximum avant</translation>
    </message>
    <message>
        <source>Maximum reverse</source>
        <translation>Maximum arrière</translation>
    </message>
    <message>
        <source>Nominal forward</source>
        <translation>Nominal avant</translation>
    </message>
    <message>
        <source>Nominal reverse</source>
        <translation>Nominal arrière</translation>
    </message>
    <message>
        <source>The factory value suits most motors.</source>
        <translation>La valeur d’usine convient à la plupart des moteurs.</translation>
    </message>
    <message>
        <source>The live count. Written only while the output is off.</source>
        <translation>Le compte actuel. Écrit seulement quand la sortie est coupée.</translation>
    </message>
    <message>
        <source>Index clears position</source>
        <translation>L’index remet la position à 0</translation>
    </message>
    <message>
        <source>At the index edge chosen below. Lost at power-off.</source>
        <translation>Au front d’index choisi ci-dessous. Perdu à la mise hors tension.</translation>
    </message>
    <message>
        <source>Forward switch clears position</source>
        <translation>Le contact avant remet à 0</translation>
    </message>
    <message>
        <source>Reverse switch clears position</source>
        <translation>Le contact arrière remet à 0</translation>
    </message>
    <message>
        <source>Index acts on its rising edge</source>
        <translation>Index sur front montant</translation>
    </message>
    <message>
        <source>Off is the falling edge. Lost at power-off.</source>
        <translation>Arrêt&#xa0;: front descendant. Perdu à la mise hors tension.</translation>
    </message>
    <message>
        <source>Present faults</source>
        <translation>Défauts présents</translation>
    </message>
    <message>
        <source>1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication.</source>
        <translation>1 surintensité, 2 surchauffe, 4 sous-tension, 8 driver de grille, 16 communication.</translation>
    </message>
    <message>
        <source>Faults since the last clear</source>
        <translation>Défauts depuis l’effacement</translation>
    </message>
    <message>
        <source>The bits of the present faults. Writing anything but 0 reads them and clears them.</source>
        <translation>Les bits des défauts présents. Écrire autre chose que 0 les lit et les efface.</translation>
    </message>
    <message>
        <source>Over-current count</source>
        <translation>Nombre de surintensités</translation>
    </message>
    <message>
        <source>Over-temperature count</source>
        <translation>Nombre de surchauffes</translation>
    </message>
    <message>
        <source>Under-voltage count</source>
        <translation>Nombre de sous-tensions</translation>
    </message>
    <message>
        <source>Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.</source>
        <translation>Alimentation sous 5,75 V pendant 5 s. Écrire autre chose que 0 lit le compteur et l’efface.</translation>
    </message>
    <message>
        <source>Gate driver count</source>
        <translation>Défauts driver de grille</translation>
    </message>
    <message>
        <source>Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.</source>
        <translation>Généralement un court-circuit entre M+ et M−. Écrire autre chose que 0 lit le compteur et l’efface.</translation>
    </message>
    <message>
        <source>Communication loss count</source>
        <translation>Pertes de communication</translation>
    </message>
    <message>
        <source>Since the last power-up. Writing anything but 0 reads the count and clears it.</source>
        <translation>Depuis la dernière mise sous tension. Écrire autre chose que 0 lit le compteur et l’efface.</translation>
    </message>
    <message>
        <source>Continuous limit</source>
        <translation>Limite continue</translation>
    </message>
    <message>
        <source>At or above the peak limit, limiting starts as soon as this is exceeded.</source>
        <translation>Si elle n’est pas inférieure à la limite de pointe, la limitation commence dès son dépassement.</translation>
    </message>
    <message>
        <source>Peak limit</source>
        <translation>Limite de pointe</translation>
    </message>
    <message>
        <source>Above it for the peak duration, the current is brought down to the continuous limit.</source>
        <translation>Au-dessus pendant la durée de pointe, le courant est ramené à la limite continue.</translation>
    </message>
    <message>
        <source>Peak duration</source>
        <translation>Durée de pointe</translation>
    </message>
    <message>
        <source>Time above the peak limit before limiting starts; 0 limits at once.</source>
        <translation>Temps au-dessus de la limite de pointe avant limitation&#x202f;; 0 limite immédiatement.</translation>
    </message>
    <message>
        <source>Current limit enabled</source>
        <translation>Limitation de courant activée</translation>
    </message>
    <message>
        <source>Off is the factory setting: nothing limits the current.</source>
        <translation>Arrêt est le réglage d’usine&#xa0;: rien ne limite le courant.</translation>
    </message>
    <message>
        <source>Analog period</source>
        <translation>Période analogique</translation>
    </message>
    <message>
        <source>Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.</source>
        <translation>Millisecondes entre trames, bien que le fabricant parle de cadence. Revient à 100 à chaque redémarrage.</translation>
    </message>
    <message>
        <source>Encoder period</source>
        <translation>Période codeur</translation>
    </message>
    <message>
        <source>General period</source>
        <translation>Période générale</translation>
    </message>
    <message>
        <source>Milliseconds between frames. At most 50, because followers stop after 104 ms without one.</source>
        <translation>Millisecondes entre trames. 50 au plus, car les suiveurs s’arrêtent après 104 ms sans trame.</translation>
    </message>
    <message>
        <source>current is limited</source>
        <translation>courant limité</translation>
    </message>
    <message>
        <source>Forward limit switch</source>
        <translation>Fin de course avant</translation>
    </message>
    <message>
        <source>forward limit switch holds</source>
        <translation>fin de course avant actif</translation>
    </message>
    <message>
        <source>Reverse limit switch</source>
        <translation>Fin de course arrière</translation>
    </message>
    <message>
        <source>reverse limit switch holds</source>
        <translation>fin de course arrière actif</translation>
    </message>
    <message>
        <source>forward soft limit holds</source>
        <translation>limite logicielle avant active</translation>
    </message>
    <message>
        <source>reverse soft limit holds</source>
        <translation>limite logicielle arrière active</translation>
    </message>
    <message>
        <source>Limit override</source>
        <translation>Fins de course ignorés</translation>
    </message>
    <message>
        <source>the set-point decides which limit switches count</source>
        <translation>la consigne détermine quels fins de course comptent</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>Halte</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>immobilisé</translation>
    </message>
    <message>
        <source>Pin of the forward limit switch</source>
        <translation>Broche du fin de course avant</translation>
    </message>
    <message>
        <source>Pin of the reverse limit switch</source>
        <translation>Broche du fin de course arrière</translation>
    </message>
    <message>
        <source>Encoder pin A</source>
        <translation>Broche A du codeur</translation>
    </message>
    <message>
        <source>Encoder pin B</source>
        <translation>Broche B du codeur</translation>
    </message>
    <message>
        <source>Encoder index pin</source>
        <translation>Broche d’index du codeur</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>débit en bauds</translation>
    </message>
    <message>
        <source>From the data sheet.</source>
        <translation>D’après la fiche technique.</translation>
    </message>
    <message>
        <source>format</source>
        <translation>format</translation>
    </message>
    <message>
        <source>Data bits, parity, stop bits. Not told.</source>
        <translation>Bits de données, parité, bits d’arrêt. Non indiqué.</translation>
    </message>
    <message>
        <source>line ending</source>
        <translation>fin de ligne</translation>
    </message>
    <message>
        <source>Not told; the terminal program that the data sheet names sends cr.</source>
        <translation>Non indiqué&#x202f;; le programme de terminal que nomme la fiche technique envoie cr.</translation>
    </message>
    <message>
        <source>greeting holds</source>
        <translation>l’accueil contient</translation>
    </message>
    <message>
        <source>The data sheet tells this word, and not the whole greeting.</source>
        <translation>La fiche technique indique ce mot, mais pas tout le message d’accueil.</translation>
    </message>
    <message>
        <source>refusal holds</source>
        <translation>le refus contient</translation>
    </message>
    <message>
        <source>Not told. Words with | between them, in whatever case.</source>
        <translation>Non indiqué. Mots séparés par |, sans distinction de casse.</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pause</translation>
    </message>
    <message>
        <source>Least time from one line to the next in milliseconds, from the data sheet.</source>
        <translation>Temps minimal d’une ligne à la suivante en millisecondes, d’après la fiche technique.</translation>
    </message>
    <message>
        <source>leaves with</source>
        <translation>sortie par</translation>
    </message>
    <message>
        <source>Typed at the end. &quot;none&quot; leaves it to jumper and reset.</source>
        <translation>Saisi à la fin. «&#xa0;none&#xa0;» laisse faire le cavalier et le reset.</translation>
    </message>
    <message>
        <source>counts/s (safe)</source>
        <translation>counts/s (sûr)</translation>
    </message>
    <message>
        <source>counts/s × 4096</source>
        <translation>counts/s × 4096</translation>
    </message>
    <message>
        <source>as the library</source>
        <translation>selon la bibliothèque</translation>
    </message>
    <message>
        <source>as the data sheet</source>
        <translation>selon la fiche technique</translation>
    </message>
    <message>
        <source>The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly moves; the opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.</source>
        <translation>La fiche technique se contredit sur les consignes de vitesse. En simples counts/s, une carte qui attend × 4096 bouge à peine&#x202f;; l’erreur inverse demande la pleine vitesse. Ne le changez que si une carte bouge à peine, et avec une petite limite de puissance.</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give polarity and edges of the inputs opposite bits. The library is more likely right; an experiment with the status bit tells.</source>
        <translation>La fiche technique et la bibliothèque du fabricant donnent des bits opposés à la polarité et aux fronts des entrées. La bibliothèque a plus probablement raison&#x202f;; une expérience avec le bit d’état tranche.</translation>
    </message>
    <message>
        <source>Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.</source>
        <translation>Unités de puissance (8191 est la pleine puissance) que donne un gain brut de 1. Le fabricant ne le dit pas&#x202f;; une expérience le trouve.</translation>
    </message>
    <message>
        <source>velocity target</source>
        <translation>consigne de vitesse</translation>
    </message>
    <message>
        <source>input polarity</source>
        <translation>polarité d’entrée</translation>
    </message>
    <message>
        <source>velocity P scale</source>
        <translation>échelle de vitesse P</translation>
    </message>
    <message>
        <source>velocity I scale</source>
        <translation>échelle de vitesse I</translation>
    </message>
    <message>
        <source>position P scale</source>
        <translation>échelle de position P</translation>
    </message>
    <message>
        <source>position I scale</source>
        <translation>échelle de position I</translation>
    </message>
    <message>
        <source>position D scale</source>
        <translation>échelle de position D</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Bits d’état</translation>
    </message>
    <message>
        <source>adapter, 3.3 V</source>
        <translation>adaptateur, 3,3 V</translation>
    </message>
    <message>
        <source>Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND</source>
        <translation>Schéma&#xa0;: le cavalier relie AUX1 et AUX2&#x202f;; TX de l’adaptateur à RX de la carte, RX à TX, 3,3 V, GND</translation>
    </message>
    <message>
        <source>Drawing: the jumper between AUX1 and AUX2 is taken out</source>
        <translation>Schéma&#xa0;: le cavalier entre AUX1 et AUX2 est retiré</translation>
    </message>
    <message>
        <source>open: nothing is connected, the pin is high</source>
        <translation>ouverte&#xa0;: rien n’est raccordé, la broche est à l’état haut</translation>
    </message>
    <message>
        <source>connected to GND: the pin is low</source>
        <translation>reliée à GND&#xa0;: la broche est à l’état bas</translation>
    </message>
    <message>
        <source>Find the gain scales</source>
        <translation>Trouver les échelles de gain</translation>
    </message>
    <message>
        <source>The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to two minutes, with the power that you allow here: first with constant power, then with one gain alone at a time, which grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. Gains and limits are put back at the end.</source>
        <translation>Le fabricant ne dit pas ce que vaut un gain brut. Le moteur d’un axe tourne en va-et-vient pendant une à deux minutes, à la puissance que vous autorisez ici&#xa0;: d’abord à puissance constante, puis avec un seul gain à la fois, qui augmente jusqu’à ce que le moteur bouge. L’arbre doit tourner librement, de quelques tours dans chaque sens, et personne ne doit le toucher. Gains et limites sont rétablis à la fin.</translation>
    </message>
    <message>
        <source>Find the input polarity</source>
        <translation>Trouver la polarité d’entrée</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give the polarity of the inputs opposite bits. The input of one axis is set up with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, the counter stays, and the input is set up afterwards as it was.</source>
        <translation>La fiche technique et la bibliothèque du fabricant donnent des bits opposés à la polarité des entrées. L’entrée d’un axe est configurée avec les deux, et le bit d’état indique lequel est actif au niveau de la broche. Rien ne bouge, le compteur reste, et l’entrée est ensuite reconfigurée comme avant.</translation>
    </message>
    <message>
        <source>The input pin of this axis is</source>
        <translation>La broche d’entrée de cet axe est</translation>
    </message>
    <message>
        <source>encoder glitch</source>
        <translation>parasite du codeur</translation>
    </message>
    <message>
        <source>overspeed</source>
        <translation>survitesse</translation>
    </message>
    <message>
        <source>Close the jumper</source>
        <translation>Poser le cavalier</translation>
    </message>
    <message>
        <source>Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; the board gets 3.3 V only.</source>
        <translation>Posez un cavalier sur AUX1 et AUX2. L’adaptateur série a des niveaux de 3,3 V, son TX va à RX et son RX à TX&#x202f;; la carte ne reçoit que 3,3 V.</translation>
    </message>
    <message>
        <source>Reset the board</source>
        <translation>Réinitialiser la carte</translation>
    </message>
    <message>
        <source>Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it.</source>
        <translation>Appuyez sur son reset, ou éteignez-la et rallumez-la. Si la ligne de reset est câblée, ce programme y envoie une impulsion.</translation>
    </message>
    <message>
        <source>The bootloader greets</source>
        <translation>Le bootloader se présente</translation>
    </message>
    <message>
        <source>Its greeting on the serial port holds the word &quot;bootloader&quot;.</source>
        <translation>Son message d’accueil sur le port série contient le mot «&#xa0;bootloader&#xa0;».</translation>
    </message>
    <message>
        <source>The file is sent</source>
        <translation>Le fichier est envoyé</translation>
    </message>
    <message>
        <source>Line by line, each after the confirmation of the one before. Leave the jumper where it is.</source>
        <translation>Ligne par ligne, chacune après la confirmation de la précédente. Laissez le cavalier en place.</translation>
    </message>
    <message>
        <source>Take the jumper out</source>
        <translation>Retirer le cavalier</translation>
    </message>
    <message>
        <source>Then the board starts its new firmware. If it does not, reset it once more.</source>
        <translation>La carte démarre alors son nouveau firmware. Sinon, réinitialisez-la encore une fois.</translation>
    </message>
    <message>
        <source>The version is compared</source>
        <translation>La version est comparée</translation>
    </message>
    <message>
        <source>The board is asked for it over SPI.</source>
        <translation>Elle est demandée à la carte par SPI.</translation>
    </message>
    <message>
        <source>A board that is cut stays in its bootloader. Leave the jumper in and run the update again.</source>
        <translation>Une carte interrompue reste dans son bootloader. Laissez le cavalier en place et relancez la mise à jour.</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>Voie 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>Voie 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>Voie 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>Voie 4</translation>
    </message>
    <message>
        <source>Stream and velocity</source>
        <translation>Flux et vitesse</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>capteur d’origine</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>impulsion d’index</translation>
    </message>
    <message>
        <source>both edges</source>
        <translation>deux fronts</translation>
    </message>
    <message>
        <source>active high</source>
        <translation>actif à l’état haut</translation>
    </message>
    <message>
        <source>active low</source>
        <translation>actif à l’état bas</translation>
    </message>
    <message>
        <source>record at the positive end</source>
        <translation>enregistrer à l’extrémité positive</translation>
    </message>
    <message>
        <source>set at the positive end</source>
        <translation>régler à l’extrémité positive</translation>
    </message>
    <message>
        <source>record at the negative end</source>
        <translation>enregistrer à l’extrémité négative</translation>
    </message>
    <message>
        <source>set at the negative end</source>
        <translation>régler à l’extrémité négative</translation>
    </message>
    <message>
        <source>Of the position loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the four are sent together.</source>
        <translation>De la boucle de position, en unités propres à la carte, d’échelle non documentée. Relecture impossible&#x202f;; les quatre sont envoyés ensemble.</translation>
    </message>
    <message>
        <source>Bound of the position loop&apos;s integral, in power units: 8191 is full power. Cannot be read back.</source>
        <translation>Borne de l’intégrale de la boucle de position, en unités de puissance&#xa0;: 8191 est la pleine puissance. Relecture impossible.</translation>
    </message>
    <message>
        <source>Of the velocity loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the three are sent together.</source>
        <translation>De la boucle de vitesse, en unités propres à la carte, d’échelle non documentée. Relecture impossible&#x202f;; les trois sont envoyés ensemble.</translation>
    </message>
    <message>
        <source>Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be read back.</source>
        <translation>Puissance maximale dans tous les modes, 1 est la pleine puissance. La valeur de démarrage de la carte n’est pas documentée&#xa0;: commencez petit. Relecture impossible.</translation>
    </message>
    <message>
        <source>Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.</source>
        <translation>Vitesse maximale dans les deux boucles fermées. La valeur de démarrage de la carte n’est pas documentée. Relecture impossible.</translation>
    </message>
    <message>
        <source>Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.</source>
        <translation>Accélération maximale dans les deux boucles fermées&#x202f;; 0 est sans limite. Relecture impossible.</translation>
    </message>
    <message>
        <source>What the input of the channel is for. Cannot be read back; the five values of an input are sent together.</source>
        <translation>À quoi sert l’entrée de la voie. Relecture impossible&#x202f;; les cinq valeurs d’une entrée sont envoyées ensemble.</translation>
    </message>
    <message>
        <source>At which level the input is active. Data sheet and the maker&apos;s library say it with opposite bits: which one the board follows is a setting of the device, and an experiment tells.</source>
        <translation>À quel niveau l’entrée est active. La fiche technique et la bibliothèque du fabricant le disent avec des bits opposés&#xa0;: celui que suit la carte est un réglage de l’appareil, et une expérience tranche.</translation>
    </message>
    <message>
        <source>At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, as for the polarity.</source>
        <translation>À quelle extrémité du contact la position est enregistrée, ou aussi chargée dans le compteur. Fiche technique et bibliothèque divergent, comme pour la polarité.</translation>
    </message>
    <message>
        <source>Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.</source>
        <translation>Distance entre les deux extrémités du contact&#x202f;; 0 est une butée unique. Relecture impossible.</translation>
    </message>
    <message>
        <source>What the counter becomes at the edge. Cannot be read back.</source>
        <translation>La valeur que prend le compteur au front. Relecture impossible.</translation>
    </message>
    <message>
        <source>What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. The program needs the full position.</source>
        <translation>Ce que la carte envoie de cette voie&#xa0;: bits 0 et 1 taille de la position, 2 relatif, 3 vitesse, 5 état. Le programme a besoin de la position complète.</translation>
    </message>
    <message>
        <source>The encoder&apos;s counter. Writing it moves the zero, not the motor.</source>
        <translation>Le compteur du codeur. L’écrire déplace le zéro, pas le moteur.</translation>
    </message>
    <message>
        <source>Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.</source>
        <translation>De la télémétrie, en unités de 40,96 µs&#xa0;: 244 fait 10 ms, 49 fait 2 ms, 0 est l’arrêt.</translation>
    </message>
    <message>
        <source>What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.</source>
        <translation>Ce qu’un paquet du flux contient en plus&#xa0;: bit 0 horodatage, bit 1 nombre de périodes sautées.</translation>
    </message>
    <message>
        <source>Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.</source>
        <translation>Fronts, fois quatre, sur lesquels la vitesse est mesurée&#xa0;: moins est plus rapide et plus grossier. 8 convient au réglage.</translation>
    </message>
    <message>
        <source>Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.</source>
        <translation>Temps maximal sur lequel la vitesse est mesurée&#xa0;: 2 à cette puissance, fois 0,64 µs&#x202f;; 20 fait 671 ms.</translation>
    </message>
    <message>
        <source>Position P</source>
        <translation>Position P</translation>
    </message>
    <message>
        <source>Position I</source>
        <translation>Position I</translation>
    </message>
    <message>
        <source>Position D</source>
        <translation>Position D</translation>
    </message>
    <message>
        <source>Position windup</source>
        <translation>Position windup</translation>
    </message>
    <message>
        <source>Velocity P</source>
        <translation>Vitesse P</translation>
    </message>
    <message>
        <source>Velocity I</source>
        <translation>Vitesse I</translation>
    </message>
    <message>
        <source>Velocity D</source>
        <translation>Vitesse D</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>Limite de puissance</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>Limite de vitesse</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>Limite d’accélération</translation>
    </message>
    <message>
        <source>Input mode</source>
        <translation>Entrée&#xa0;: mode</translation>
    </message>
    <message>
        <source>Input polarity</source>
        <translation>Entrée&#xa0;: polarité</translation>
    </message>
    <message>
        <source>Input edge</source>
        <translation>Entrée&#xa0;: front</translation>
    </message>
    <message>
        <source>Input spacing</source>
        <translation>Entrée&#xa0;: écart</translation>
    </message>
    <message>
        <source>Input position</source>
        <translation>Entrée&#xa0;: position</translation>
    </message>
    <message>
        <source>Data mask</source>
        <translation>Masque de données</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Compteur de position</translation>
    </message>
    <message>
        <source>Stream period</source>
        <translation>Période du flux</translation>
    </message>
    <message>
        <source>Stream contents</source>
        <translation>Contenu du flux</translation>
    </message>
    <message>
        <source>History length</source>
        <translation>Longueur d’historique</translation>
    </message>
    <message>
        <source>History time bits</source>
        <translation>Bits de temps d’historique</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>the port cannot be opened</source>
        <translation>impossible d’ouvrir le port</translation>
    </message>
    <message>
        <source>check its name and that it is plugged in</source>
        <translation>vérifiez son nom et qu’il est branché</translation>
    </message>
    <message>
        <source>avrdude finds no such programmer on USB</source>
        <translation>avrdude ne trouve aucun programmateur de ce type sur USB</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after avrdude:</source>
        <translation>branchez-le, et vérifiez que son type est celui indiqué après avrdude:</translation>
    </message>
    <message>
        <source>run it again, with a shorter cable</source>
        <translation>relancez, avec un câble plus court</translation>
    </message>
    <message>
        <source>the programmer is there, but no microcontroller answers it</source>
        <translation>le programmateur est là, mais aucun microcontrôleur ne lui répond</translation>
    </message>
    <message>
        <source>check the six pins and the supply</source>
        <translation>vérifiez les six broches et l’alimentation</translation>
    </message>
    <message>
        <source>avrdude knows no programmer of this name</source>
        <translation>avrdude ne connaît aucun programmateur de ce nom</translation>
    </message>
    <message>
        <source>&apos;avrdude -c ?&apos; lists them</source>
        <translation>«&#xa0;avrdude -c ?&#xa0;» les énumère</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>l’ouverture du port n’est pas autorisée</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>ajoutez-vous au groupe dialout et reconnectez-vous</translation>
    </message>
    <message>
        <source>what answers is no ATmega328P</source>
        <translation>ce qui répond n’est pas un ATmega328P</translation>
    </message>
    <message>
        <source>check that the programmer sits on the controller</source>
        <translation>vérifiez que le programmateur est bien sur le contrôleur</translation>
    </message>
    <message>
        <source>no bootloader answers</source>
        <translation>aucun bootloader ne répond</translation>
    </message>
    <message>
        <source>restart the controller just before the start, or use a programmer on its pins</source>
        <translation>redémarrez le contrôleur juste avant de commencer, ou utilisez un programmateur sur ses broches</translation>
    </message>
    <message>
        <source>nothing answers the programmer</source>
        <translation>rien ne répond au programmateur</translation>
    </message>
    <message>
        <source>check its cable and the supply of the controller</source>
        <translation>vérifiez son câble et l’alimentation du contrôleur</translation>
    </message>
    <message>
        <source>Velocity as reported</source>
        <translation>Vitesse telle que transmise</translation>
    </message>
    <message>
        <source>Position in the turn</source>
        <translation>Position dans le tour</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Entrée analogique 1</translation>
    </message>
    <message>
        <source>Analog input 2</source>
        <translation>Entrée analogique 2</translation>
    </message>
    <message>
        <source>Analog input 3</source>
        <translation>Entrée analogique 3</translation>
    </message>
    <message>
        <source>Analog input 4</source>
        <translation>Entrée analogique 4</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entrées numériques</translation>
    </message>
    <message>
        <source>the motor stalled</source>
        <translation>le moteur s’est bloqué</translation>
    </message>
    <message>
        <source>the position left its range upwards</source>
        <translation>la position est sortie de sa plage vers le haut</translation>
    </message>
    <message>
        <source>the position left its range downwards</source>
        <translation>la position est sortie de sa plage vers le bas</translation>
    </message>
    <message>
        <source>it has no such command</source>
        <translation>il n’a pas cette commande</translation>
    </message>
    <message>
        <source>wrong number of data bytes</source>
        <translation>nombre d’octets de données incorrect</translation>
    </message>
    <message>
        <source>a value that it does not take</source>
        <translation>une valeur qu’il n’accepte pas</translation>
    </message>
    <message>
        <source>not possible while the motor is not started</source>
        <translation>impossible tant que le moteur n’est pas démarré</translation>
    </message>
    <message>
        <source>data bytes where none belong</source>
        <translation>octets de données là où il n’en faut pas</translation>
    </message>
    <message>
        <source>I2C: nobody answers</source>
        <translation>I2C&#xa0;: personne ne répond</translation>
    </message>
    <message>
        <source>I2C: bus error</source>
        <translation>I2C&#xa0;: erreur de bus</translation>
    </message>
    <message>
        <source>I2C: arbitration lost</source>
        <translation>I2C&#xa0;: arbitrage perdu</translation>
    </message>
    <message>
        <source>I2C: indeterminate state</source>
        <translation>I2C&#xa0;: état indéterminé</translation>
    </message>
    <message>
        <source>I2C: the bus did not become ready</source>
        <translation>I2C&#xa0;: le bus n’est pas devenu prêt</translation>
    </message>
    <message>
        <source>I2C: sending took too long</source>
        <translation>I2C&#xa0;: l’envoi a pris trop de temps</translation>
    </message>
    <message>
        <source>I2C: receiving took too long</source>
        <translation>I2C&#xa0;: la réception a pris trop de temps</translation>
    </message>
    <message>
        <source>I2C: a packet was overwritten</source>
        <translation>I2C&#xa0;: un paquet a été écrasé</translation>
    </message>
    <message>
        <source>I2C: a packet of wrong length</source>
        <translation>I2C&#xa0;: un paquet de longueur incorrecte</translation>
    </message>
    <message>
        <source>UART: out of memory</source>
        <translation>UART&#xa0;: mémoire insuffisante</translation>
    </message>
    <message>
        <source>UART: framing error</source>
        <translation>UART&#xa0;: erreur de trame</translation>
    </message>
    <message>
        <source>UART: parity error</source>
        <translation>UART&#xa0;: erreur de parité</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow</source>
        <translation>UART&#xa0;: débordement du tampon de réception</translation>
    </message>
    <message>
        <source>UART: data overrun (the datasheet means a framing error)</source>
        <translation>UART&#xa0;: perte de données (la fiche technique veut dire erreur de trame)</translation>
    </message>
    <message>
        <source>UART: sending took too long (the datasheet means a parity error)</source>
        <translation>UART&#xa0;: l’envoi a pris trop de temps (la fiche technique veut dire erreur de parité)</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow, by the datasheet&apos;s number</source>
        <translation>UART&#xa0;: débordement du tampon de réception, selon le numéro de la fiche technique</translation>
    </message>
    <message>
        <source>UART: data overrun, by the datasheet&apos;s number</source>
        <translation>UART&#xa0;: perte de données, selon le numéro de la fiche technique</translation>
    </message>
    <message>
        <source>a frame paused for more than 50 ms</source>
        <translation>une trame s’est interrompue plus de 50 ms</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>somme de contrôle incorrecte</translation>
    </message>
    <message>
        <source>D1 and D2: what one count of the current converter stands for; D3 tells ampere.</source>
        <translation>D1 et D2&#xa0;: ce que vaut un count du convertisseur de courant&#x202f;; D3 donne des ampères.</translation>
    </message>
    <message>
        <source>serial bootloader</source>
        <translation>bootloader série</translation>
    </message>
    <message>
        <source>serial bootloader, without reset</source>
        <translation>bootloader série, sans reset</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Digital lines</source>
        <translation>Lignes numériques</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented.</source>
        <translation>D1, D2&#xa0;: 1/65280 de la pleine sortie par count d’erreur&#x202f;; 4000 est la pleine sortie à 16 counts. L’échelle de D3 n’est pas documentée.</translation>
    </message>
    <message>
        <source>D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only.</source>
        <translation>D1, D2&#xa0;: 1/16711680 de la pleine sortie par count d’erreur et cycle de 1,024 ms. La borne de l’intégrale ne suit P qu’au prochain redémarrage.</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms.</source>
        <translation>D1, D2&#xa0;: 1/65280 de la pleine sortie par count de variation de l’erreur en un cycle de 1,024 ms.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Accélération</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535.</source>
        <translation>Des mouvements avec profil. D1&#xa0;: 65535 au plus.</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.</source>
        <translation>Des mouvements avec profil. D1&#xa0;: 65535 au plus. D1 et D2 peuvent dépasser leur cible au-dessus de 2500, et calculent faux à partir de 46340.</translation>
    </message>
    <message>
        <source>Firmware of D1 and D2 stores it and does not limit anything.</source>
        <translation>Le firmware de D1 et D2 le mémorise et ne limite rien.</translation>
    </message>
    <message>
        <source>Time above the limit</source>
        <translation>Temps au-dessus de la limite</translation>
    </message>
    <message>
        <source>In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.</source>
        <translation>Effectif après un redémarrage. D1 et D2 le prennent jusque-là pour la limite de courant&#x202f;; la limite est donc réécrite ensuite.</translation>
    </message>
    <message>
        <source>Outputs among the lines</source>
        <translation>Lignes en sortie</translation>
    </message>
    <message>
        <source>1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.</source>
        <translation>1, 2, 4, 8 pour DIO1 à DIO4&#x202f;; un bit à 1 fait une sortie. DIO1 et DIO3 à l’état bas pendant 3 s lancent la programmation analogique de l’appareil, DIO2 et DIO4 à l’état bas rétablissent ses réglages d’usine.</translation>
    </message>
    <message>
        <source>Levels of the outputs</source>
        <translation>Niveaux des sorties</translation>
    </message>
    <message>
        <source>Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.</source>
        <translation>Bits comme pour les sens&#x202f;; les entrées ignorent les leurs. Relecture impossible, perdu à la mise hors tension.</translation>
    </message>
    <message>
        <source>Node id</source>
        <translation>Id de nœud</translation>
    </message>
    <message>
        <source>Its address on the line. In force after a restart; until then it answers under the old one.</source>
        <translation>Son adresse sur la ligne. Effective après un redémarrage&#x202f;; jusque-là, il répond sous l’ancienne.</translation>
    </message>
    <message>
        <source>Acceptance mask</source>
        <translation>Masque d’acceptation</translation>
    </message>
    <message>
        <source>Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart.</source>
        <translation>Bits d’adresse pris en compte. 255&#xa0;: seulement la sienne&#x202f;; moins forme un groupe qui exécute ce qui est envoyé à l’un de ses membres, et réagit à leurs réponses. Effectif après un redémarrage.</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>Débit</translation>
    </message>
    <message>
        <source>In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600.</source>
        <translation>Effectif après un redémarrage. Se lit comme le débit auquel il répond. 115200 est en réalité 119048&#xa0;: préférez 57600.</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>Niveau d’erreur</translation>
    </message>
    <message>
        <source>D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.</source>
        <translation>D1 et D2. Le niveau 1 ferait échouer chaque lecture, donc seul 0 est proposé&#xa0;: écrivez-le là où un autre programme a mis 1.</translation>
    </message>
    <message>
        <source>Reactions to errors</source>
        <translation>Réactions aux erreurs</translation>
    </message>
    <message>
        <source>D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.</source>
        <translation>D3. Deux bits pour chacune des 20 erreurs, la première en bas&#xa0;: 0 rien, 1 arrêt, 2 halte. La correspondance des erreurs n’est pas documentée.</translation>
    </message>
    <message>
        <source>Anti-windup</source>
        <translation>Anti-windup</translation>
    </message>
    <message>
        <source>D3. Bound of the integral; its scale is not documented.</source>
        <translation>D3. Borne de l’intégrale&#x202f;; son échelle n’est pas documentée.</translation>
    </message>
    <message>
        <source>Digital input 1</source>
        <translation>Entrée numérique 1</translation>
    </message>
    <message>
        <source>Digital input 2</source>
        <translation>Entrée numérique 2</translation>
    </message>
    <message>
        <source>Digital input 3</source>
        <translation>Entrée numérique 3</translation>
    </message>
    <message>
        <source>Digital input 4</source>
        <translation>Entrée numérique 4</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>à la main</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>état trouvé</translation>
    </message>
    <message>
        <source>before restore</source>
        <translation>avant restauration</translation>
    </message>
    <message>
        <source>before import</source>
        <translation>avant import</translation>
    </message>
    <message>
        <source>before tuning</source>
        <translation>avant réglage</translation>
    </message>
    <message>
        <source>before update</source>
        <translation>avant mise à jour</translation>
    </message>
    <message>
        <source>%1 % of the samples were lost in a second</source>
        <translation>%1 % des échantillons ont été perdus en une seconde</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4</source>
        <translation>%1 %2 est hors de %3 … %4</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4 %5</source>
        <translation>%1 %2 est hors de %3 … %4 %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4, what firmware of dialect %5 takes</source>
        <translation>%1 %2 est hors de %3 … %4, ce qu’accepte le firmware du dialecte %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside the envelope, which ends at %3</source>
        <translation>%1 %2 est hors de l’enveloppe, qui s’arrête à %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (code %2)</source>
        <translation>%1 (code %2)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1 at %2 % duty</source>
        <translation>%1 à %2 % de rapport cyclique</translation>
    </message>
    <message>
        <source>%1 at byte %2</source>
        <translation>%1 à l’octet %2</translation>
    </message>
    <message>
        <source>%1 becomes %2, it was %3: the device stores it</source>
        <translation>%1 devient %2, au lieu de %3&#xa0;: l’appareil le mémorise</translation>
    </message>
    <message>
        <source>%1 becomes %2: the device stores it</source>
        <translation>%1 devient %2&#xa0;: l’appareil le mémorise</translation>
    </message>
    <message>
        <source>%1 begins no line of such a log</source>
        <translation>%1 ne commence aucune ligne d’un tel journal</translation>
    </message>
    <message>
        <source>%1 belongs to the unit that the file was saved from</source>
        <translation>%1 appartient à l’appareil dont provient le fichier</translation>
    </message>
    <message>
        <source>%1 bit/s is no rate of a serial line</source>
        <translation>%1 bit/s n’est pas un débit de ligne série</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>impossible de créer %1</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>impossible de créer %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>impossible d’ouvrir %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be painted</source>
        <translation>%1 ne peut pas être dessiné</translation>
    </message>
    <message>
        <source>%1 cannot be read from the device</source>
        <translation>%1 ne peut pas être lu dans l’appareil</translation>
    </message>
    <message>
        <source>%1 cannot be read, so it could not be put back</source>
        <translation>%1 ne peut pas être lu, donc ne pourrait pas être rétabli</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>impossible de lire %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be restarted from here</source>
        <translation>%1 ne peut pas être redémarré d’ici</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>impossible de démarrer %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>impossible d’écrire %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>impossible d’écrire %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s</source>
        <translation>%1 ne prend pas en charge %2 bit/s</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s: %3</source>
        <translation>%1 ne prend pas en charge %2 bit/s&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 cannot do %2: %3</source>
        <translation>%1 ne prend pas en charge %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 cannot do SPI mode 1 at this speed</source>
        <translation>%1 ne prend pas en charge le mode SPI 1 à cette vitesse</translation>
    </message>
    <message>
        <source>%1 cannot take old samples: %2</source>
        <translation>%1 ne peut pas recevoir d’anciens échantillons&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 could not be measured</source>
        <translation>%1 n’a pas pu être mesuré</translation>
    </message>
    <message>
        <source>%1 data bytes are announced, %2 are there</source>
        <translation>%1 octets de données sont annoncés, %2 sont là</translation>
    </message>
    <message>
        <source>%1 did not come back within %2</source>
        <translation>%1 n’est pas revenu en %2</translation>
    </message>
    <message>
        <source>%1 digits, an even number is needed</source>
        <translation>%1 chiffres, il en faut un nombre pair</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 ne répond pas</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 ne répond pas&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 does not exist in this device&apos;s dialect</source>
        <translation>%1 n’existe pas dans le dialecte de cet appareil</translation>
    </message>
    <message>
        <source>%1 does not open: its driver has not answered for %2 s</source>
        <translation>%1 ne s’ouvre pas&#xa0;: son pilote n’a pas répondu depuis %2 s</translation>
    </message>
    <message>
        <source>%1 does not tell its position</source>
        <translation>%1 n’indique pas sa position</translation>
    </message>
    <message>
        <source>%1 exists and is no socket</source>
        <translation>%1 existe et n’est pas un socket</translation>
    </message>
    <message>
        <source>%1 failed (%2)</source>
        <translation>%1 a échoué (%2)</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 a échoué&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 frames recorded, %2 are missing</source>
        <translation>%1 trames enregistrées, il en manque %2</translation>
    </message>
    <message>
        <source>%1 frames recorded, none is missing</source>
        <translation>%1 trames enregistrées, aucune ne manque</translation>
    </message>
    <message>
        <source>%1 frames were lost, the kernel keeps only %2 for this program</source>
        <translation>%1 trames ont été perdues, le noyau n’en garde que %2 pour ce programme</translation>
    </message>
    <message>
        <source>%1 has %2 axes and %3 sets of gains</source>
        <translation>%1 a %2 axes et %3 jeux de gains</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of picture</source>
        <translation>%1 a un nom qui ne finit par aucun type d’image</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of report</source>
        <translation>%1 a un nom qui ne finit par aucun type de rapport</translation>
    </message>
    <message>
        <source>%1 has no %2</source>
        <translation>%1 n’a pas de %2</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos; to be set</source>
        <translation>%1 n’a pas de «&#xa0;%2&#xa0;» réglable</translation>
    </message>
    <message>
        <source>%1 has no buffered moves</source>
        <translation>%1 n’a pas de mouvements en tampon</translation>
    </message>
    <message>
        <source>%1 has no channel of samples</source>
        <translation>%1 n’a pas de voie d’échantillons</translation>
    </message>
    <message>
        <source>%1 has no command that zeroes its position</source>
        <translation>%1 n’a pas de commande qui remet sa position à zéro</translation>
    </message>
    <message>
        <source>%1 has no dialect &apos;%2&apos;</source>
        <translation>%1 n’a pas de dialecte «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 has no duty command</source>
        <translation>%1 n’a pas de commande de rapport cyclique</translation>
    </message>
    <message>
        <source>%1 has no duty command, so &apos;%2&apos; is not measured</source>
        <translation>%1 n’a pas de commande de rapport cyclique, «&#xa0;%2&#xa0;» n’est donc pas mesuré</translation>
    </message>
    <message>
        <source>%1 has no firmware update here</source>
        <translation>%1 n’a pas de mise à jour de firmware ici</translation>
    </message>
    <message>
        <source>%1 has no frame in it</source>
        <translation>%1 ne contient aucune trame</translation>
    </message>
    <message>
        <source>%1 has no frame of %2</source>
        <translation>%1 ne contient aucune trame de %2</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tried</source>
        <translation>%1 n’a pas de boucle «&#xa0;%2&#xa0;» à essayer</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tuned</source>
        <translation>%1 n’a pas de boucle «&#xa0;%2&#xa0;» réglable</translation>
    </message>
    <message>
        <source>%1 has no loop that can be tried</source>
        <translation>%1 n’a pas de boucle à essayer</translation>
    </message>
    <message>
        <source>%1 has no number that could be set</source>
        <translation>%1 n’a pas de numéro réglable</translation>
    </message>
    <message>
        <source>%1 has no option &apos;%2&apos;</source>
        <translation>%1 n’a pas d’option «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1 has no samples</source>
        <translation>%1 n’a pas d’échantillons</translation>
    </message>
    <message>
        <source>%1 has no setting that could be written to every unit</source>
        <translation>%1 n’a pas de réglage qui puisse être écrit dans chaque appareil</translation>
    </message>
    <message>
        <source>%1 has no such limit of its own, so nothing bounds the motor</source>
        <translation>%1 n’a pas de telle limite propre, donc rien ne borne le moteur</translation>
    </message>
    <message>
        <source>%1 has not told where it stands</source>
        <translation>%1 n’a pas indiqué où il se trouve</translation>
    </message>
    <message>
        <source>%1 holds no limits of experiments</source>
        <translation>%1 ne contient pas de limites d’expériences</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>%1 in its bootloader instead of %2</source>
        <translation>%1 dans son bootloader au lieu de %2</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 au lieu de %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 est %2</translation>
    </message>
    <message>
        <source>%1 is %2, %3</source>
        <translation>%1 est %2, %3</translation>
    </message>
    <message>
        <source>%1 is a device and has no end</source>
        <translation>%1 est un périphérique et n’a pas de fin</translation>
    </message>
    <message>
        <source>%1 is a folder</source>
        <translation>%1 est un dossier</translation>
    </message>
    <message>
        <source>%1 is a network interface, but not one for CAN</source>
        <translation>%1 est une interface réseau, mais pas CAN</translation>
    </message>
    <message>
        <source>%1 is a recording: it can be watched, not written to or driven</source>
        <translation>%1 est un enregistrement&#xa0;: il peut être observé, mais ni écrit ni piloté</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 est de retour</translation>
    </message>
    <message>
        <source>%1 is being opened already</source>
        <translation>%1 est déjà en cours d’ouverture</translation>
    </message>
    <message>
        <source>%1 is being recorded already</source>
        <translation>%1 est déjà en cours d’enregistrement</translation>
    </message>
    <message>
        <source>%1 is bus-off</source>
        <translation>%1 est bus-off</translation>
    </message>
    <message>
        <source>%1 is busy: it serves one client at a time</source>
        <translation>%1 est occupé&#xa0;: il ne sert qu’un client à la fois</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be put aside</source>
        <translation>%1 est endommagé et ne peut pas être mis de côté</translation>
    </message>
    <message>
        <source>%1 is error-passive</source>
        <translation>%1 est error-passive</translation>
    </message>
    <message>
        <source>%1 is error-warning</source>
        <translation>%1 est error-warning</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 a disparu</translation>
    </message>
    <message>
        <source>%1 is in use by another program</source>
        <translation>%1 est utilisé par un autre programme</translation>
    </message>
    <message>
        <source>%1 is locked by another program</source>
        <translation>%1 est verrouillé par un autre programme</translation>
    </message>
    <message>
        <source>%1 is lost: %2; waiting up to %3 for it to come back</source>
        <translation>%1 est perdu&#xa0;: %2&#x202f;; attente de son retour jusqu’à %3</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manque</translation>
    </message>
    <message>
        <source>%1 is never part of an experiment</source>
        <translation>%1 ne fait jamais partie d’une expérience</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in dec</source>
        <translation>%1 n’est pas un identifiant CAN décimal</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in hex</source>
        <translation>%1 n’est pas un identifiant CAN hexadécimal</translation>
    </message>
    <message>
        <source>%1 is no CAN link</source>
        <translation>%1 n’est pas une liaison CAN</translation>
    </message>
    <message>
        <source>%1 is no device profile</source>
        <translation>%1 n’est pas un profil d’appareil</translation>
    </message>
    <message>
        <source>%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew</source>
        <translation>%1 n’est pas une liste d’appareils et est ignoré&#xa0;: la prochaine recherche prendra toute sa durée et l’écrira à nouveau</translation>
    </message>
    <message>
        <source>%1 is no project of this version</source>
        <translation>%1 n’est pas un projet de cette version</translation>
    </message>
    <message>
        <source>%1 is no recording</source>
        <translation>%1 n’est pas un enregistrement</translation>
    </message>
    <message>
        <source>%1 is no serial port</source>
        <translation>%1 n’est pas un port série</translation>
    </message>
    <message>
        <source>%1 is no time stamp</source>
        <translation>%1 n’est pas un horodatage</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 n’est pas un fichier</translation>
    </message>
    <message>
        <source>%1 is not a hexadecimal digit</source>
        <translation>%1 n’est pas un chiffre hexadécimal</translation>
    </message>
    <message>
        <source>%1 is not an MCAP file</source>
        <translation>%1 n’est pas un fichier MCAP</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 n’est pas un objet</translation>
    </message>
    <message>
        <source>%1 is not in this program</source>
        <translation>%1 n’existe pas dans ce programme</translation>
    </message>
    <message>
        <source>%1 is not installed</source>
        <translation>%1 n’est pas installé</translation>
    </message>
    <message>
        <source>%1 is not known to firmware of dialect %2</source>
        <translation>%1 n’est pas connu du firmware de dialecte %2</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 n’est pas ouvert</translation>
    </message>
    <message>
        <source>%1 is not updated over its own link</source>
        <translation>%1 ne se met pas à jour par sa propre liaison</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 est en lecture seule</translation>
    </message>
    <message>
        <source>%1 is served by another program already</source>
        <translation>%1 est déjà servi par un autre programme</translation>
    </message>
    <message>
        <source>%1 is served by another simulator</source>
        <translation>%1 est servi par un autre simulateur</translation>
    </message>
    <message>
        <source>%1 is switched off</source>
        <translation>%1 est désactivée</translation>
    </message>
    <message>
        <source>%1 is there already and no link to a terminal</source>
        <translation>%1 existe déjà et n’est pas un lien vers un terminal</translation>
    </message>
    <message>
        <source>%1 is updated over its own link</source>
        <translation>%1 se met à jour par sa propre liaison</translation>
    </message>
    <message>
        <source>%1 is used by another program</source>
        <translation>%1 est utilisé par un autre programme</translation>
    </message>
    <message>
        <source>%1 lines, %2 bytes; the file does not name its version</source>
        <translation>%1 lignes, %2 octets&#x202f;; le fichier n’indique pas sa version</translation>
    </message>
    <message>
        <source>%1 links are not supported yet</source>
        <translation>les liaisons %1 ne sont pas encore prises en charge</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 demande un nombre</translation>
    </message>
    <message>
        <source>%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update again</source>
        <translation>%1 lignes sur %2 ont été confirmées. Le bootloader attend toujours&#xa0;: laissez le cavalier en place et relancez la mise à jour</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; %3: %4</source>
        <translation>%1 réglages sur %2 ont été réécrits&#x202f;; %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; then the board was reset once more</source>
        <translation>%1 réglages sur %2 ont été réécrits&#x202f;; puis la carte a de nouveau été réinitialisée</translation>
    </message>
    <message>
        <source>%1 of the recipe read back different, first %2</source>
        <translation>la relecture de %1 de la recette diffère, à commencer par %2</translation>
    </message>
    <message>
        <source>%1 only listens, nothing can be sent</source>
        <translation>%1 ne fait qu’écouter, aucun envoi n’est possible</translation>
    </message>
    <message>
        <source>%1 parameters gave no answer</source>
        <translation>%1 paramètres sans réponse</translation>
    </message>
    <message>
        <source>%1 said nothing for a minute and was ended</source>
        <translation>%1 n’a rien dit pendant une minute et a été interrompu</translation>
    </message>
    <message>
        <source>%1 said nothing for too long</source>
        <translation>%1 n’a rien dit depuis trop longtemps</translation>
    </message>
    <message>
        <source>%1 settings written again</source>
        <translation>%1 réglages réécrits</translation>
    </message>
    <message>
        <source>%1 takes no frames: %2 wait to be sent</source>
        <translation>%1 n’accepte pas de trames&#xa0;: %2 attendent l’envoi</translation>
    </message>
    <message>
        <source>%1 to number %2: %3</source>
        <translation>%1 au numéro %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1 transmit and %2 receive errors</source>
        <translation>%1 erreurs d’émission et %2 de réception</translation>
    </message>
    <message>
        <source>%1 units answer as number %2</source>
        <translation>%1 appareils répondent sous le numéro %2</translation>
    </message>
    <message>
        <source>%1 values are not what they were left as; the history has both</source>
        <translation>%1 valeurs ne sont plus telles qu’elles avaient été laissées&#x202f;; l’historique a les deux</translation>
    </message>
    <message>
        <source>%1 was %2 and is not known to be cleared</source>
        <translation>%1 valait %2&#x202f;; son effacement n’est pas établi</translation>
    </message>
    <message>
        <source>%1 was changed while it was played</source>
        <translation>%1 a été modifié pendant la lecture</translation>
    </message>
    <message>
        <source>%1 was closed before it was open</source>
        <translation>%1 a été fermé avant d’être ouvert</translation>
    </message>
    <message>
        <source>%1 was disconnected</source>
        <translation>%1 a été déconnecté</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of this program (schema %2, known here is %3)</source>
        <translation>%1 provient d’une version plus récente de ce programme (schéma %2, connu ici&#xa0;: %3)</translation>
    </message>
    <message>
        <source>%1 was not confirmed</source>
        <translation>%1 n’a pas été confirmé</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 a été refusé&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3</source>
        <translation>%1 a été arrêté&#xa0;: %2, %3</translation>
    </message>
    <message>
        <source>%1 was switched off</source>
        <translation>%1 a été désactivée</translation>
    </message>
    <message>
        <source>%1 was unknown when the file was written</source>
        <translation>%1 était inconnu lors de l’écriture du fichier</translation>
    </message>
    <message>
        <source>%1 was unplugged</source>
        <translation>%1 a été débranché</translation>
    </message>
    <message>
        <source>%1 was written as %2 but reads %3</source>
        <translation>%1 a été écrit à %2 mais on lit %3</translation>
    </message>
    <message>
        <source>%1 where a record begins with a colon, is this an Intel HEX file?</source>
        <translation>%1 là où un enregistrement commence par un deux-points&#xa0;: est-ce un fichier Intel HEX&#x202f;?</translation>
    </message>
    <message>
        <source>%1 with %2 transmit and %3 receive errors</source>
        <translation>%1 avec %2 erreurs d’émission et %3 de réception</translation>
    </message>
    <message>
        <source>%1 would be %2 of its smallest steps, too few to mean anything</source>
        <translation>%1 vaudrait %2 de ses plus petits pas, trop peu pour être significatif</translation>
    </message>
    <message>
        <source>%1 would have to be %2, which it cannot be</source>
        <translation>%1 devrait valoir %2, ce qui est impossible</translation>
    </message>
    <message>
        <source>%1 written, read back and equal</source>
        <translation>%1 écrits, relus et égaux</translation>
    </message>
    <message>
        <source>%1 written; %2 of them cannot be read back</source>
        <translation>%1 écrits&#x202f;; relecture impossible pour %2 d’entre eux</translation>
    </message>
    <message>
        <source>%1 written; they cannot be read back</source>
        <translation>%1 écrits&#x202f;; relecture impossible</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, and the device switched its output off</source>
        <translation>%1, et l’appareil a coupé sa sortie</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1, more than half a step from its target</source>
        <translation>%1, à plus d’un demi-échelon de sa cible</translation>
    </message>
    <message>
        <source>%1, told to run at more than half a step</source>
        <translation>%1, avec une consigne de plus d’un demi-échelon</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: %2 is above %3</source>
        <translation>%1&#xa0;: %2 est supérieur à %3</translation>
    </message>
    <message>
        <source>%1: %2 is below %3</source>
        <translation>%1&#xa0;: %2 est inférieur à %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1&#xa0;: %2 n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms</source>
        <translation>%1&#xa0;: %2 de %3 ms est plus fin que ce que suit l’appareil, qui prend une consigne toutes les %4 ms</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither on nor off</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» n’est ni on ni off</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1&#xa0;: «&#xa0;%2&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>%1: cannot be read (system error %2)</source>
        <translation>%1&#xa0;: lecture impossible (erreur système %2)</translation>
    </message>
    <message>
        <source>%1: its value is of the wrong kind</source>
        <translation>%1&#xa0;: sa valeur est du mauvais type</translation>
    </message>
    <message>
        <source>%1: its value says %2, its raw value %3</source>
        <translation>%1&#xa0;: sa valeur dit %2, sa valeur brute %3</translation>
    </message>
    <message>
        <source>%1: legal is %2</source>
        <translation>%1&#xa0;: valeurs admises %2</translation>
    </message>
    <message>
        <source>%1: legal is %2 … %3</source>
        <translation>%1&#xa0;: valeurs admises %2 … %3</translation>
    </message>
    <message>
        <source>%1: no permission to read it</source>
        <translation>%1&#xa0;: pas d’autorisation de lecture</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1&#xa0;: fichier introuvable</translation>
    </message>
    <message>
        <source>%1: not a number</source>
        <translation>%1&#xa0;: pas un nombre</translation>
    </message>
    <message>
        <source>%1: raw is not a whole number</source>
        <translation>%1&#xa0;: raw n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>%1: raw value %2 is out of range</source>
        <translation>%1&#xa0;: la valeur brute %2 est hors plage</translation>
    </message>
    <message>
        <source>%1: status %2 has no meaning</source>
        <translation>%1&#xa0;: l’état %2 n’a pas de signification</translation>
    </message>
    <message>
        <source>%1: the device answers &apos;%2&apos;</source>
        <translation>%1&#xa0;: l’appareil répond «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>%1: the device refused the value</source>
        <translation>%1&#xa0;: l’appareil a refusé la valeur</translation>
    </message>
    <message>
        <source>%1: this firmware does not know the parameter</source>
        <translation>%1&#xa0;: ce firmware ne connaît pas le paramètre</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1&#x202f;; %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no journal that stations share</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un registre partagé par des postes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no path of a socket: it has 1 to 107 characters</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un chemin de socket&#xa0;: il a de 1 à 107 caractères</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une durée en secondes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for the option &apos;%2&apos; of %3</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une valeur pour l’option «&#xa0;%2&#xa0;» de %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un appareil&#xa0;: il faut LIAISON/FAMILLE:ADRESSE, par exemple sim:can/dmc60c:5</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une liaison&#xa0;: il faut SCHEME:PATH, par exemple socketcan:can0 ou sim:</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a simulated device: %2</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un appareil simulé&#xa0;: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not qtcan:PLUGIN:INTERFACE</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas qtcan:PLUGIN:INTERFACE</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a number</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a text</source>
        <translation>«&#xa0;%1&#xa0;» doit être un texte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre entier</translation>
    </message>
    <message>
        <source>a name has no line break, tabulator or other control character</source>
        <translation>un nom n’a ni saut de ligne, ni tabulation, ni autre caractère de contrôle</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be an object in braces</source>
        <translation>«&#xa0;%1&#xa0;» doit être un objet entre accolades</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no interface</source>
        <translation>«&#xa0;%1&#xa0;» ne nomme aucune interface</translation>
    </message>
    <message>
        <source>&apos;encoder&apos; is true: it counts both ways</source>
        <translation>«&#xa0;encoder&#xa0;» est true&#xa0;: il compte dans les deux sens</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl snapshots&apos; lists those there are</source>
        <translation>«&#xa0;motorbenchctl snapshots&#xa0;» énumère ceux qui existent</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl trials&apos; lists those there are</source>
        <translation>«&#xa0;motorbenchctl trials&#xa0;» énumère ceux qui existent</translation>
    </message>
    <message>
        <source>&apos;store&apos; must be true or false</source>
        <translation>«&#xa0;store&#xa0;» doit être true ou false</translation>
    </message>
    <message>
        <source>&apos;to&apos; is missing</source>
        <translation>«&#xa0;to&#xa0;» manque</translation>
    </message>
    <message>
        <source>--font-scale takes 0.5 to 3</source>
        <translation>--font-scale accepte 0.5 à 3</translation>
    </message>
    <message>
        <source>--language takes one of %1</source>
        <translation>--language accepte l’une de ces valeurs : %1</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no picture</source>
        <translation>--out «&#xa0;%1&#xa0;» n’est pas une image</translation>
    </message>
    <message>
        <source>%1 is no report</source>
        <translation>%1 n’est pas un rapport</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no PDF</source>
        <translation>--out «&#xa0;%1&#xa0;» n’est pas un PDF</translation>
    </message>
    <message>
        <source>--help tells what there is</source>
        <translation>--help dit ce qu’il y a</translation>
    </message>
    <message>
        <source>--plot FILE or --report FILE, and --out FILE belong together</source>
        <translation>--plot FICHIER ou --report FICHIER va avec --out FICHIER</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, such as 1280x800</source>
        <translation>--size accepte LARGEURxHAUTEUR, par exemple 1280x800</translation>
    </message>
    <message>
        <source>--target is missing</source>
        <translation>--target manque</translation>
    </message>
    <message>
        <source>--target: &apos;%1&apos; is unknown</source>
        <translation>--target&#xa0;: «&#xa0;%1&#xa0;» est inconnu</translation>
    </message>
    <message>
        <source>--tour needs a folder for its pictures</source>
        <translation>--tour demande un dossier pour ses images</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into a Supermodified</source>
        <translation>--via&#xa0;: «&#xa0;%1&#xa0;» n’est pas un accès à un Supermodified</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into an Abstract DC Drive</source>
        <translation>--via&#xa0;: «&#xa0;%1&#xa0;» n’est pas un accès à un Abstract DC Drive</translation>
    </message>
    <message>
        <source>0 is no divisor</source>
        <translation>0 n’est pas un diviseur</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 octet</translation>
    </message>
    <message>
        <source>A programmer on the pins erases the chip first, the stored settings and the serial bootloader with it: save the parameters before. The bootloader keeps both.</source>
        <translation>Un programmateur sur les broches efface d’abord la puce, avec elle les réglages mémorisés et le bootloader série&#xa0;: sauvegardez les paramètres avant. Le bootloader conserve les deux.</translation>
    </message>
    <message>
        <source>Abstract DC Drives are found on CAN links only</source>
        <translation>les Abstract DC Drives n’existent que sur des liaisons CAN</translation>
    </message>
    <message>
        <source>Abstract DC Drives found: %1</source>
        <translation>Abstract DC Drives trouvés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Abstract DC Drives live on CAN links only</source>
        <translation>les Abstract DC Drives n’existent que sur des liaisons CAN</translation>
    </message>
    <message>
        <source>All pages written</source>
        <translation>Toutes les pages écrites</translation>
    </message>
    <message>
        <source>Assign number</source>
        <translation>Attribuer un numéro</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Autoréglage</translation>
    </message>
    <message>
        <source>CAN high is not connected</source>
        <translation>CAN high n’est pas raccordé</translation>
    </message>
    <message>
        <source>CAN high is short to battery</source>
        <translation>CAN high est en court-circuit avec la batterie</translation>
    </message>
    <message>
        <source>CAN high is short to ground</source>
        <translation>CAN high est en court-circuit avec la masse</translation>
    </message>
    <message>
        <source>CAN high is short to supply</source>
        <translation>CAN high est en court-circuit avec l’alimentation</translation>
    </message>
    <message>
        <source>CAN low is not connected</source>
        <translation>CAN low n’est pas raccordé</translation>
    </message>
    <message>
        <source>CAN low is short to CAN high</source>
        <translation>CAN low est en court-circuit avec CAN high</translation>
    </message>
    <message>
        <source>CAN low is short to battery</source>
        <translation>CAN low est en court-circuit avec la batterie</translation>
    </message>
    <message>
        <source>CAN low is short to ground</source>
        <translation>CAN low est en court-circuit avec la masse</translation>
    </message>
    <message>
        <source>CAN low is short to supply</source>
        <translation>CAN low est en court-circuit avec l’alimentation</translation>
    </message>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>impossible d’ouvrir les sockets CAN&#xa0;: %1</translation>
    </message>
    <message>
        <source>CRC refused, nothing was erased; trying variant %1</source>
        <translation>CRC refusé, rien n’a été effacé&#x202f;; essai de la variante %1</translation>
    </message>
    <message>
        <source>Connecting through OpenOCD</source>
        <translation>Connexion via OpenOCD</translation>
    </message>
    <message>
        <source>Connecting through avrdude</source>
        <translation>Connexion via avrdude</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Compter depuis 0</translation>
    </message>
    <message>
        <source>DMC60C controllers are found on CAN links only</source>
        <translation>les contrôleurs DMC60C n’existent que sur des liaisons CAN</translation>
    </message>
    <message>
        <source>DMC60C found: %1</source>
        <translation>DMC60C trouvés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, none was proven. %2</source>
        <translation>Le dialecte %1 a été choisi à la main, aucun n’était prouvé. %2</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, the unit answered as %2. %3</source>
        <translation>Le dialecte %1 a été choisi à la main, l’appareil répondait comme %2. %3</translation>
    </message>
    <message>
        <source>Do a write again</source>
        <translation>Refaire une écriture</translation>
    </message>
    <message>
        <source>Drives of two dialects answer with this offset in the recording.</source>
        <translation>Des variateurs de deux dialectes répondent à cet offset dans l’enregistrement.</translation>
    </message>
    <message>
        <source>Enter bootloader</source>
        <translation>Entrée dans le bootloader</translation>
    </message>
    <message>
        <source>Erasing flash</source>
        <translation>Effacement de la flash</translation>
    </message>
    <message>
        <source>Erasing the stored settings</source>
        <translation>Effacement des réglages mémorisés</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Expérience</translation>
    </message>
    <message>
        <source>FAMILY:ADDRESS is needed, such as dmc60c:5</source>
        <translation>il faut FAMILLE:ADRESSE, par exemple dmc60c:5</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Réponse fréquentielle</translation>
    </message>
    <message>
        <source>GPIO line %1 is used by another program or driver</source>
        <translation>la ligne GPIO %1 est utilisée par un autre programme ou pilote</translation>
    </message>
    <message>
        <source>GPIO line %1: %2</source>
        <translation>ligne GPIO %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>GetDescriptors: a field ends too early</source>
        <translation>GetDescriptors&#xa0;: un champ finit trop tôt</translation>
    </message>
    <message>
        <source>GetFlashSeqnum: 4 bytes were expected</source>
        <translation>GetFlashSeqnum&#xa0;: 4 octets étaient attendus</translation>
    </message>
    <message>
        <source>GetFwver answered with %1 bytes</source>
        <translation>GetFwver a répondu par %1 octets</translation>
    </message>
    <message>
        <source>GetFwver: 6 bytes were expected</source>
        <translation>GetFwver&#xa0;: 6 octets étaient attendus</translation>
    </message>
    <message>
        <source>Giving it number %1</source>
        <translation>Attribution du numéro %1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifier</translation>
    </message>
    <message>
        <source>It answers, but not as any known dialect; it can be watched but not driven.</source>
        <translation>Il répond, mais dans aucun dialecte connu&#x202f;; il peut être observé mais pas piloté.</translation>
    </message>
    <message>
        <source>It is not driven: %1.</source>
        <translation>Il n’est pas piloté&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Its answers fit no known dialect.</source>
        <translation>Ses réponses ne correspondent à aucun dialecte connu.</translation>
    </message>
    <message>
        <source>Its error level is 1, so every reading fails. Set error.level to 0.</source>
        <translation>Son niveau d’erreur est 1, donc chaque lecture échoue. Mettez error.level à 0.</translation>
    </message>
    <message>
        <source>Keep the gains of a trial</source>
        <translation>Conserver les gains d’un essai</translation>
    </message>
    <message>
        <source>Look at the restarted unit</source>
        <translation>Examiner l’appareil redémarré</translation>
    </message>
    <message>
        <source>Look for gains that are owed</source>
        <translation>Rechercher les gains restant à rétablir</translation>
    </message>
    <message>
        <source>Looking for Abstract DC Drives</source>
        <translation>Recherche d’Abstract DC Drives</translation>
    </message>
    <message>
        <source>Looking for DMC60C</source>
        <translation>Recherche de DMC60C</translation>
    </message>
    <message>
        <source>Looking for Supermodified nodes at %1 bit/s</source>
        <translation>Recherche de nœuds Supermodified à %1 bit/s</translation>
    </message>
    <message>
        <source>Looking for the controller</source>
        <translation>Recherche du contrôleur</translation>
    </message>
    <message>
        <source>Looking for the drive</source>
        <translation>Recherche du variateur</translation>
    </message>
    <message>
        <source>No application runs; update its firmware.</source>
        <translation>Aucune application ne tourne&#x202f;; mettez à jour son firmware.</translation>
    </message>
    <message>
        <source>Number %1 is used by %2 units; give each its own before one is driven.</source>
        <translation>Le numéro %1 est utilisé par %2 appareils&#x202f;; donnez à chacun le sien avant d’en piloter un.</translation>
    </message>
    <message>
        <source>OpenOCD ended without saying why</source>
        <translation>OpenOCD s’est terminé sans dire pourquoi</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, and the drive answers again</source>
        <translation>OpenOCD a vérifié la flash, et le variateur répond à nouveau</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, but nothing answers as %1; the new firmware may have another offset or bit rate: scan again</source>
        <translation>OpenOCD a vérifié la flash, mais rien ne répond comme %1&#x202f;; le nouveau firmware a peut-être un autre offset ou débit&#xa0;: relancez la recherche</translation>
    </message>
    <message>
        <source>OpenOCD: %1</source>
        <translation>OpenOCD&#xa0;: %1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Page %1</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Contrôle préalable</translation>
    </message>
    <message>
        <source>Product %1 is not known to be a DMC60C.</source>
        <translation>Le produit %1 n’est pas connu comme DMC60C.</translation>
    </message>
    <message>
        <source>Put gains back</source>
        <translation>Rétablir les gains</translation>
    </message>
    <message>
        <source>Put values back</source>
        <translation>Rétablir les valeurs</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lu</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Lire et effacer les défauts</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>Lire les paramètres</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Redémarrage</translation>
    </message>
    <message>
        <source>Restarting the drive</source>
        <translation>Redémarrage du variateur</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP a été actionné</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Mémorisé</translation>
    </message>
    <message>
        <source>Saving the %1 loop</source>
        <translation>Mémorisation de la boucle %1</translation>
    </message>
    <message>
        <source>Set telemetry rate</source>
        <translation>Régler la cadence de télémétrie</translation>
    </message>
    <message>
        <source>Set telemetry rate: %1</source>
        <translation>Réglage de la cadence de télémétrie&#xa0;: %1</translation>
    </message>
    <message>
        <source>Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Plusieurs variateurs répondent avec l’offset %1&#x202f;; les offsets sont compilés dans le firmware, donnez-en donc un autre à l’un d’eux et flashez-le.</translation>
    </message>
    <message>
        <source>So old that nothing but its power stops it; it can be watched but not driven.</source>
        <translation>Si ancien que seule la coupure d’alimentation l’arrête&#x202f;; il peut être observé mais pas piloté.</translation>
    </message>
    <message>
        <source>Speaks the document&apos;s codes, which no published firmware does.</source>
        <translation>Parle les codes du document, ce que ne fait aucun firmware publié.</translation>
    </message>
    <message>
        <source>Speaks the firmware&apos;s codes, not the document&apos;s.</source>
        <translation>Parle les codes du firmware, pas ceux du document.</translation>
    </message>
    <message>
        <source>Speaks the legacy frames of 8 bytes, as the published master does.</source>
        <translation>Parle les anciennes trames de 8 octets, comme le maître publié.</translation>
    </message>
    <message>
        <source>Store to flash</source>
        <translation>Mémoriser en flash</translation>
    </message>
    <message>
        <source>Supermodified controllers are found on serial links only</source>
        <translation>les contrôleurs Supermodified n’existent que sur des liaisons série</translation>
    </message>
    <message>
        <source>Supermodified found: %1</source>
        <translation>Supermodified trouvés&#xa0;: %1</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>Prendre un instantané</translation>
    </message>
    <message>
        <source>The adapter has no %1 bit/s</source>
        <translation>L’adaptateur ne prend pas en charge %1 bit/s</translation>
    </message>
    <message>
        <source>The bootloader runs; restart the unit or update its firmware.</source>
        <translation>Le bootloader est actif&#x202f;; redémarrez l’appareil ou mettez à jour son firmware.</translation>
    </message>
    <message>
        <source>The controller tells no version: the programmer&apos;s own verify and the controller&apos;s answer prove the update.</source>
        <translation>Le contrôleur n’indique pas de version&#xa0;: la vérification du programmateur et la réponse du contrôleur prouvent la mise à jour.</translation>
    </message>
    <message>
        <source>The drive tells no version: the programmer&apos;s own verify and the drive&apos;s answer prove the update.</source>
        <translation>Le variateur n’indique pas de version&#xa0;: la vérification du programmateur et la réponse du variateur prouvent la mise à jour.</translation>
    </message>
    <message>
        <source>The image holds a bootloader too, so it needs a programmer on the pins.</source>
        <translation>L’image contient aussi un bootloader, il faut donc un programmateur sur les broches.</translation>
    </message>
    <message>
        <source>The image writes the settings pages: stored gains are replaced.</source>
        <translation>L’image écrit les pages de réglages&#xa0;: les gains mémorisés sont remplacés.</translation>
    </message>
    <message>
        <source>The recording does not tell which codes it speaks: it was asked for what all answer alike.</source>
        <translation>L’enregistrement n’indique pas quels codes il parle&#xa0;: on lui a demandé ce à quoi tous répondent de même.</translation>
    </message>
    <message>
        <source>The serial bootloader listens for a moment after power-up only: restart the controller when the update begins.</source>
        <translation>Le bootloader série n’écoute qu’un instant après la mise sous tension&#xa0;: redémarrez le contrôleur au début de la mise à jour.</translation>
    </message>
    <message>
        <source>This unit has no number and no application; assign a number, then update its firmware.</source>
        <translation>Cet appareil n’a ni numéro ni application&#x202f;; attribuez un numéro, puis mettez à jour son firmware.</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 63.</source>
        <translation>Cet appareil n’a pas encore de numéro&#x202f;; attribuez-en un de 1 à 63.</translation>
    </message>
    <message>
        <source>Undo a write</source>
        <translation>Annuler une écriture</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Mettre à jour le firmware</translation>
    </message>
    <message>
        <source>Verifying flash</source>
        <translation>Vérification de la flash</translation>
    </message>
    <message>
        <source>Wait for %1</source>
        <translation>Attente de %1</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>Attente de l’écriture de la flash par l’appareil</translation>
    </message>
    <message>
        <source>Write parameters</source>
        <translation>Écrire les paramètres</translation>
    </message>
    <message>
        <source>Write settings again</source>
        <translation>Réécrire les réglages</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Écriture de %1</translation>
    </message>
    <message>
        <source>Writing flash</source>
        <translation>Écriture de la flash</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrit</translation>
    </message>
    <message>
        <source>&quot;via&quot; must name the other way in, such as &quot;%1&quot;</source>
        <translation>«&#xa0;via&#xa0;» doit nommer l’autre accès, par exemple «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a DMC60C has a number from 0 to 63, not %1</source>
        <translation>un DMC60C a un numéro de 0 à 63, pas %1</translation>
    </message>
    <message>
        <source>a DMC60C has no mode &apos;%1&apos;</source>
        <translation>un DMC60C n’a pas de mode «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a DMC60C has one axis</source>
        <translation>un DMC60C a un seul axe</translation>
    </message>
    <message>
        <source>a DMC60C has the gain slots 0 and 1</source>
        <translation>un DMC60C a les jeux de gains 0 et 1</translation>
    </message>
    <message>
        <source>a DMC60C is simulated on a CAN link</source>
        <translation>un DMC60C se simule sur une liaison CAN</translation>
    </message>
    <message>
        <source>a DMC60C is updated over its own link</source>
        <translation>un DMC60C se met à jour par sa propre liaison</translation>
    </message>
    <message>
        <source>a GPIO line is CHIP:LINE, as in gpiochip0:25, not &apos;%1&apos;</source>
        <translation>une ligne GPIO est CHIP:LIGNE, comme gpiochip0:25, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has no address but 0</source>
        <translation>un QuadQuad2Drv n’a pas d’autre adresse que 0</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has one kind of chip</source>
        <translation>un QuadQuad2Drv a un seul type de puce</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv is simulated on the board&apos;s end of an SPI link</source>
        <translation>un QuadQuad2Drv se simule côté carte d’une liaison SPI</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv lives on an SPI link</source>
        <translation>un QuadQuad2Drv est sur une liaison SPI</translation>
    </message>
    <message>
        <source>a Supermodified has an id from 1 to 127, not %1</source>
        <translation>un Supermodified a un id de 1 à 127, pas %1</translation>
    </message>
    <message>
        <source>a Supermodified has no mode &apos;%1&apos;</source>
        <translation>un Supermodified n’a pas de mode «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>a Supermodified has one axis and one set of gains</source>
        <translation>un Supermodified a un seul axe et un seul jeu de gains</translation>
    </message>
    <message>
        <source>a Supermodified has one kind of microcontroller</source>
        <translation>un Supermodified a un seul type de microcontrôleur</translation>
    </message>
    <message>
        <source>a Supermodified is simulated on a serial link</source>
        <translation>un Supermodified se simule sur une liaison série</translation>
    </message>
    <message>
        <source>a Supermodified is written by avrdude</source>
        <translation>un Supermodified s’écrit avec avrdude</translation>
    </message>
    <message>
        <source>a bit</source>
        <translation>un bit</translation>
    </message>
    <message>
        <source>a bootloader needs the board&apos;s serial line, such as boot=pty:./boot</source>
        <translation>un bootloader demande la ligne série de la carte, par exemple boot=pty:./boot</translation>
    </message>
    <message>
        <source>a buffered move is not acknowledged yet</source>
        <translation>un mouvement en tampon n’est pas encore acquitté</translation>
    </message>
    <message>
        <source>a demo remembers no layouts</source>
        <translation>une démo ne retient pas les dispositions</translation>
    </message>
    <message>
        <source>a device cannot follow itself</source>
        <translation>un appareil ne peut pas se suivre lui-même</translation>
    </message>
    <message>
        <source>a device number is 1 … 63</source>
        <translation>un numéro d’appareil va de 1 à 63</translation>
    </message>
    <message>
        <source>a divisor changes all gains at once</source>
        <translation>un diviseur change tous les gains à la fois</translation>
    </message>
    <message>
        <source>a drive of dialect LL has no code for stop</source>
        <translation>un variateur de dialecte LL n’a pas de code d’arrêt</translation>
    </message>
    <message>
        <source>a formula assigns nothing</source>
        <translation>une formule n’affecte rien</translation>
    </message>
    <message>
        <source>a formula has at most 4000 characters</source>
        <translation>une formule a 4000 caractères au plus</translation>
    </message>
    <message>
        <source>a half swing</source>
        <translation>une demi-oscillation</translation>
    </message>
    <message>
        <source>a load takes %1 of what P makes of a step, at most 10 %</source>
        <translation>une charge prend %1 de ce que P tire d’un échelon, au plus 10 %</translation>
    </message>
    <message>
        <source>a motor is driven on this line</source>
        <translation>un moteur est piloté sur cette ligne</translation>
    </message>
    <message>
        <source>a motor is driven on this line at %1 bit/s, and this node has another rate</source>
        <translation>un moteur est piloté sur cette ligne à %1 bit/s, et ce nœud a un autre débit</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>un nom a de 1 à 64 caractères</translation>
    </message>
    <message>
        <source>a name may hold Latin-1 characters only</source>
        <translation>un nom ne peut contenir que des caractères Latin-1</translation>
    </message>
    <message>
        <source>a node id is 1 … 127</source>
        <translation>un id de nœud va de 1 à 127</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>une parenthèse n’est pas fermée</translation>
    </message>
    <message>
        <source>a part of them is in force after a restart only</source>
        <translation>une partie n’est effective qu’après un redémarrage</translation>
    </message>
    <message>
        <source>a profile has up to 100000 counts/s and 1000000 counts/s²</source>
        <translation>un profil va jusqu’à 100000 counts/s et 1000000 counts/s²</translation>
    </message>
    <message>
        <source>a push has fewer than 8 positions</source>
        <translation>une poussée a moins de 8 positions</translation>
    </message>
    <message>
        <source>a push moved the motor by fewer than 50 counts</source>
        <translation>une poussée a déplacé le moteur de moins de 50 counts</translation>
    </message>
    <message>
        <source>a push of %1 duty drew %2 A, more than half of what is allowed</source>
        <translation>une poussée à %1 de rapport cyclique a absorbé %2 A, plus de la moitié de ce qui est permis</translation>
    </message>
    <message>
        <source>a rate is a positive number, or 0 for the usual one</source>
        <translation>une cadence est un nombre positif, ou 0 pour l’habituelle</translation>
    </message>
    <message>
        <source>a recipe is a JSON object</source>
        <translation>une recette est un objet JSON</translation>
    </message>
    <message>
        <source>a record of type %1 has %2 data bytes, not %3</source>
        <translation>un enregistrement de type %1 a %2 octets de données, pas %3</translation>
    </message>
    <message>
        <source>a relative move was not answered, and is never sent twice: look where the motor stands</source>
        <translation>un mouvement relatif est resté sans réponse et n’est jamais envoyé deux fois&#xa0;: regardez où se trouve le moteur</translation>
    </message>
    <message>
        <source>a reserved bit</source>
        <translation>un bit réservé</translation>
    </message>
    <message>
        <source>a scan of the recording lists who does</source>
        <translation>une recherche dans l’enregistrement indique qui le fait</translation>
    </message>
    <message>
        <source>a simulated Abstract DC Drive</source>
        <translation>un Abstract DC Drive simulé</translation>
    </message>
    <message>
        <source>a simulated DMC60C</source>
        <translation>un DMC60C simulé</translation>
    </message>
    <message>
        <source>a simulated QuadQuad2Drv</source>
        <translation>un QuadQuad2Drv simulé</translation>
    </message>
    <message>
        <source>a simulated Supermodified</source>
        <translation>un Supermodified simulé</translation>
    </message>
    <message>
        <source>a step from the wrong place could be far too large</source>
        <translation>un échelon depuis le mauvais endroit pourrait être bien trop grand</translation>
    </message>
    <message>
        <source>a step of %1 counts overflows the loop of this firmware</source>
        <translation>un échelon de %1 counts fait déborder la boucle de ce firmware</translation>
    </message>
    <message>
        <source>a step of %1 counts with P %2, D %3</source>
        <translation>un échelon de %1 counts avec P %2, D %3</translation>
    </message>
    <message>
        <source>a step of %1 counts with the gains as they are</source>
        <translation>un échelon de %1 counts avec les gains actuels</translation>
    </message>
    <message>
        <source>a stop went first</source>
        <translation>un arrêt est passé avant</translation>
    </message>
    <message>
        <source>a swing</source>
        <translation>une oscillation</translation>
    </message>
    <message>
        <source>a temporary file for %1 cannot be written: %2</source>
        <translation>impossible d’écrire un fichier temporaire pour %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>une durée</translation>
    </message>
    <message>
        <source>a trial that is not kept</source>
        <translation>un essai qui n’est pas conservé</translation>
    </message>
    <message>
        <source>a unit that has a serial number needs no tag</source>
        <translation>un appareil qui a un numéro de série n’a pas besoin de repère</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>course</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>accepté</translation>
    </message>
    <message>
        <source>active error flag</source>
        <translation>drapeau d’erreur actif</translation>
    </message>
    <message>
        <source>add --via %1</source>
        <translation>ajoutez --via %1</translation>
    </message>
    <message>
        <source>add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1</source>
        <translation>ajoutez --via openocd:INTERFACE --target f1|f4, par exemple --via openocd:stlink --target f1</translation>
    </message>
    <message>
        <source>add ready=CHIP:LINE to the address</source>
        <translation>ajoutez ready=CHIP:LIGNE à l’adresse</translation>
    </message>
    <message>
        <source>add reset=CHIP:LINE to the address</source>
        <translation>ajoutez reset=CHIP:LIGNE à l’adresse</translation>
    </message>
    <message>
        <source>address %1 is %2 here and %3 in line %4</source>
        <translation>l’adresse %1 vaut %2 ici et %3 à la ligne %4</translation>
    </message>
    <message>
        <source>aim for a calmer loop</source>
        <translation>visez une boucle plus calme</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>les %1 sont lus</translation>
    </message>
    <message>
        <source>all pages are in the unit</source>
        <translation>toutes les pages sont dans l’appareil</translation>
    </message>
    <message>
        <source>allow CAN sockets in the container or sandbox</source>
        <translation>autorisez les sockets CAN dans le conteneur ou le bac à sable</translation>
    </message>
    <message>
        <source>allow it more power, or free its shaft</source>
        <translation>autorisez plus de puissance, ou libérez l’arbre</translation>
    </message>
    <message>
        <source>allow more current</source>
        <translation>autorisez plus de courant</translation>
    </message>
    <message>
        <source>allow more current or duty</source>
        <translation>autorisez plus de courant ou de rapport cyclique</translation>
    </message>
    <message>
        <source>allow more duty</source>
        <translation>autorisez plus de rapport cyclique</translation>
    </message>
    <message>
        <source>allow more speed</source>
        <translation>autorisez plus de vitesse</translation>
    </message>
    <message>
        <source>allow more travel</source>
        <translation>autorisez plus de course</translation>
    </message>
    <message>
        <source>allow more travel or duty</source>
        <translation>autorisez plus de course ou de rapport cyclique</translation>
    </message>
    <message>
        <source>allow more travel or speed</source>
        <translation>autorisez plus de course ou de vitesse</translation>
    </message>
    <message>
        <source>allow more, then close and open the link</source>
        <translation>autoriser plus, puis fermer et rouvrir la liaison</translation>
    </message>
    <message>
        <source>allow them in the container or sandbox</source>
        <translation>les autoriser dans le conteneur ou le bac à sable</translation>
    </message>
    <message>
        <source>an Abstract DC Drive cannot be asked for its settings</source>
        <translation>un Abstract DC Drive ne peut pas être interrogé sur ses réglages</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has an offset from 0 to 99, not %1</source>
        <translation>un Abstract DC Drive a un offset de 0 à 99, pas %1</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has no mode &apos;%1&apos;</source>
        <translation>un Abstract DC Drive n’a pas de mode «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>an Abstract DC Drive is written through a debug probe</source>
        <translation>un Abstract DC Drive s’écrit par une sonde de débogage</translation>
    </message>
    <message>
        <source>an answer of %1 bytes</source>
        <translation>une réponse de %1 octets</translation>
    </message>
    <message>
        <source>an axis from 1 to 4 and a power limit above 0 are needed</source>
        <translation>il faut un axe de 1 à 4 et une limite de puissance supérieure à 0</translation>
    </message>
    <message>
        <source>an experiment is run once at least</source>
        <translation>une expérience s’exécute au moins une fois</translation>
    </message>
    <message>
        <source>another master drives %1</source>
        <translation>un autre maître pilote %1</translation>
    </message>
    <message>
        <source>another master sends control frames to this device</source>
        <translation>un autre maître envoie des trames de commande à cet appareil</translation>
    </message>
    <message>
        <source>another program or controller drives this unit</source>
        <translation>un autre programme ou contrôleur pilote cet appareil</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>répond à nouveau</translation>
    </message>
    <message>
        <source>arbitration lost</source>
        <translation>arbitrage perdu</translation>
    </message>
    <message>
        <source>arbitration lost at bit %1</source>
        <translation>arbitrage perdu au bit %1</translation>
    </message>
    <message>
        <source>arm again</source>
        <translation>réarmez</translation>
    </message>
    <message>
        <source>arm it first</source>
        <translation>armez-le d’abord</translation>
    </message>
    <message>
        <source>arrived damaged, nothing was erased</source>
        <translation>arrivée endommagée, rien n’a été effacé</translation>
    </message>
    <message>
        <source>asking for the version</source>
        <translation>demande de la version</translation>
    </message>
    <message>
        <source>assign one before it is driven</source>
        <translation>attribuez-en un avant de le piloter</translation>
    </message>
    <message>
        <source>at most %1 with its P: use a profiled mode or several moves</source>
        <translation>au plus %1 avec son P&#xa0;: utilisez un mode avec profil ou plusieurs mouvements</translation>
    </message>
    <message>
        <source>average takes 0 to 3600 seconds, not &apos;%1&apos;</source>
        <translation>average accepte 0 à 3600 secondes, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>average takes a signal and seconds, such as average(x, 0.1)</source>
        <translation>average prend un signal et des secondes, par exemple average(x, 0.1)</translation>
    </message>
    <message>
        <source>avrdude ended without saying why</source>
        <translation>avrdude s’est terminé sans dire pourquoi</translation>
    </message>
    <message>
        <source>avrdude had the port</source>
        <translation>avrdude occupait le port</translation>
    </message>
    <message>
        <source>avrdude is not installed</source>
        <translation>avrdude n’est pas installé</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id</source>
        <translation>avrdude a relu les %1 octets et ils sont égaux, mais le contrôleur ne répond pas&#x202f;; coupez brièvement son alimentation et relancez la recherche&#xa0;: un nouveau firmware peut avoir un autre débit ou id de nœud</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2</source>
        <translation>avrdude a relu les %1 octets et ils sont égaux&#x202f;; le contrôleur répond à nouveau, dialecte %2</translation>
    </message>
    <message>
        <source>baud, format, rs485 and echo are known</source>
        <translation>connus&#xa0;: baud, format, rs485 et echo</translation>
    </message>
    <message>
        <source>become a member of its group</source>
        <translation>devenir membre de son groupe</translation>
    </message>
    <message>
        <source>begin another recipe, or another bus</source>
        <translation>commencez une autre recette, ou un autre bus</translation>
    </message>
    <message>
        <source>bit error</source>
        <translation>erreur de bit</translation>
    </message>
    <message>
        <source>boot= names a serial link, such as pty:./boot</source>
        <translation>boot= nomme une liaison série, par exemple pty:./boot</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>bootloader</translation>
    </message>
    <message>
        <source>bring it to rest first</source>
        <translation>immobilisez-le d’abord</translation>
    </message>
    <message>
        <source>bring it up</source>
        <translation>l’activer</translation>
    </message>
    <message>
        <source>bring it up as a full member</source>
        <translation>l’activer comme participant à part entière</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>erreur de bus</translation>
    </message>
    <message>
        <source>bus overload</source>
        <translation>surcharge du bus</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>bus-off</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors</source>
        <translation>bus-off&#xa0;: %1 a quitté le bus après trop d’erreurs</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors</source>
        <translation>bus-off&#xa0;: l’adaptateur a quitté le bus après trop d’erreurs</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors</source>
        <translation>bus-off&#xa0;: le contrôleur CAN a quitté le bus après trop d’erreurs</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>cannot be read (system error %1)</source>
        <translation>lecture impossible (erreur système %1)</translation>
    </message>
    <message>
        <source>change its mode, or copy it</source>
        <translation>changez ses droits d’accès, ou copiez-le</translation>
    </message>
    <message>
        <source>check its rights</source>
        <translation>vérifiez ses droits</translation>
    </message>
    <message>
        <source>check that somebody else is on the bus</source>
        <translation>vérifiez qu’il y a quelqu’un d’autre sur le bus</translation>
    </message>
    <message>
        <source>check the cable, both 120 Ω resistors, and that no number is taken twice</source>
        <translation>vérifier le câble, les deux résistances de 120 Ω, et qu’aucun numéro n’est pris deux fois</translation>
    </message>
    <message>
        <source>check the cables and try again</source>
        <translation>vérifiez les câbles et réessayez</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>vérifiez le disque</translation>
    </message>
    <message>
        <source>check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board</source>
        <translation>vérifiez le cavalier AUX1–AUX2, les fils TX et RX croisés et les niveaux de 3,3 V, puis réinitialisez la carte</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>vérifiez le chemin</translation>
    </message>
    <message>
        <source>check the probe and try again</source>
        <translation>vérifiez la sonde et réessayez</translation>
    </message>
    <message>
        <source>check the rights of the folder above it</source>
        <translation>vérifiez les droits du dossier parent</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate</source>
        <translation>vérifiez câblage, terminaison et débit</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then</source>
        <translation>vérifier câblage, terminaison et débit, puis</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then reconnect</source>
        <translation>vérifier câblage, terminaison et débit, puis reconnecter</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate; it starts again by itself</source>
        <translation>vérifier câblage, terminaison et débit&#x202f;; elle redémarre d’elle-même</translation>
    </message>
    <message>
        <source>checksum is %1, %2 is needed</source>
        <translation>la somme de contrôle est %1, il faut %2</translation>
    </message>
    <message>
        <source>chirp: %1 s hold no whole swing of %2 Hz</source>
        <translation>chirp&#xa0;: %1 s ne contiennent aucune oscillation complète à %2 Hz</translation>
    </message>
    <message>
        <source>choose a smaller --size</source>
        <translation>choisissez un --size plus petit</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>choisissez un autre dossier</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>choisissez-en un autre</translation>
    </message>
    <message>
        <source>choose another path</source>
        <translation>choisissez un autre chemin</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>close that one first (&apos;fuser %1&apos; names it)</source>
        <translation>fermez d’abord celui-là («&#xa0;fuser %1&#xa0;» l’indique)</translation>
    </message>
    <message>
        <source>close the jumper between AUX1 and AUX2, then reset the board or switch it off and on</source>
        <translation>posez le cavalier entre AUX1 et AUX2, puis réinitialisez la carte ou éteignez-la et rallumez-la</translation>
    </message>
    <message>
        <source>control is locked until one has another number</source>
        <translation>la commande est verrouillée tant que l’un d’eux n’a pas un autre numéro</translation>
    </message>
    <message>
        <source>copy the recording to another one</source>
        <translation>copiez l’enregistrement sur un autre</translation>
    </message>
    <message>
        <source>current</source>
        <translation>courant</translation>
    </message>
    <message>
        <source>current %1 A is above 1.5 × %2 A</source>
        <translation>le courant %1 A est supérieur à 1,5 × %2 A</translation>
    </message>
    <message>
        <source>current was above %1 A for %2</source>
        <translation>le courant a dépassé %1 A pendant %2</translation>
    </message>
    <message>
        <source>cut the power if the motor still turns</source>
        <translation>coupez l’alimentation si le moteur tourne encore</translation>
    </message>
    <message>
        <source>delete it, the value says the same</source>
        <translation>supprimez-le, la valeur dit la même chose</translation>
    </message>
    <message>
        <source>delete the one of the two that is old</source>
        <translation>supprimez l’ancien des deux</translation>
    </message>
    <message>
        <source>derivative and integral take one signal</source>
        <translation>derivative et integral prennent un signal</translation>
    </message>
    <message>
        <source>dialect LL has no code for stop</source>
        <translation>le dialecte LL n’a pas de code d’arrêt</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>recommencez</translation>
    </message>
    <message>
        <source>does not answer any more</source>
        <translation>ne répond plus</translation>
    </message>
    <message>
        <source>dominant bit not sent</source>
        <translation>bit dominant non envoyé</translation>
    </message>
    <message>
        <source>dry run: %1 lines would be sent over %2</source>
        <translation>simulation&#xa0;: %1 lignes seraient envoyées par %2</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written</source>
        <translation>simulation&#xa0;: %1 pages seraient écrites</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written, version %2</source>
        <translation>simulation&#xa0;: %1 pages seraient écrites, version %2</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>rapport cyclique</translation>
    </message>
    <message>
        <source>duty %1 % is above %2 %</source>
        <translation>le rapport cyclique %1 % est supérieur à %2 %</translation>
    </message>
    <message>
        <source>duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s</source>
        <translation>rapport cyclique %1 ± %2 %, au plus %3 counts/s, %4 counts dans un sens, %5 s</translation>
    </message>
    <message>
        <source>duty is a fraction from −1 to 1</source>
        <translation>le rapport cyclique est une fraction de −1 à 1</translation>
    </message>
    <message>
        <source>enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart</source>
        <translation>activez SPI dans l’arborescence matérielle (device tree&#x202f;; sur un Raspberry Pi&#xa0;: dtparam=spi=on) et redémarrez</translation>
    </message>
    <message>
        <source>end it in .pdf or .html</source>
        <translation>terminez-le par .pdf ou .html</translation>
    </message>
    <message>
        <source>end it in .png, .svg or .pdf</source>
        <translation>terminez-le par .png, .svg ou .pdf</translation>
    </message>
    <message>
        <source>end that first</source>
        <translation>terminez d’abord cela</translation>
    </message>
    <message>
        <source>end that one first, or choose another path</source>
        <translation>arrêtez d’abord celui-là, ou choisissez un autre chemin</translation>
    </message>
    <message>
        <source>ending=%1: legal are cr, lf and crlf</source>
        <translation>ending=%1&#xa0;: valeurs admises cr, lf et crlf</translation>
    </message>
    <message>
        <source>error</source>
        <translation>erreur</translation>
    </message>
    <message>
        <source>error-active</source>
        <translation>error-active</translation>
    </message>
    <message>
        <source>error-passive</source>
        <translation>error-passive</translation>
    </message>
    <message>
        <source>error-warning</source>
        <translation>error-warning</translation>
    </message>
    <message>
        <source>every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes</source>
        <translation>tout id que ce programme pourrait utiliser sur la ligne appartient au groupe d’un nœud, qui prendrait les réponses pour des commandes&#x202f;; mettez node.mask à 255 et redémarrez les nœuds</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1</source>
        <translation>chaque ligne a été confirmée, et la carte répond avec la version %1</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1, the same as before, so that nothing proves the new firmware</source>
        <translation>chaque ligne a été confirmée, et la carte répond avec la version %1, la même qu’avant, si bien que rien ne prouve le nouveau firmware</translation>
    </message>
    <message>
        <source>every line was confirmed, but the board does not answer over SPI</source>
        <translation>chaque ligne a été confirmée, mais la carte ne répond pas par SPI</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder</source>
        <translation>permutez les fils du moteur ou les phases du codeur</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder before any loop is closed</source>
        <translation>permutez les fils du moteur ou les phases du codeur avant de fermer une boucle</translation>
    </message>
    <message>
        <source>expected time, channel, value and unit</source>
        <translation>attendu&#xa0;: temps, voie, valeur et unité</translation>
    </message>
    <message>
        <source>fault &apos;%1&apos; does not parse</source>
        <translation>le défaut «&#xa0;%1&#xa0;» n’est pas analysable</translation>
    </message>
    <message>
        <source>fewer than 16 samples connect</source>
        <translation>moins de 16 échantillons contigus</translation>
    </message>
    <message>
        <source>find it by listening only</source>
        <translation>le trouver par simple écoute</translation>
    </message>
    <message>
        <source>find its gain scales first: Overview, Find the gain scales</source>
        <translation>trouvez d’abord ses échelles de gain : Vue d’ensemble, « Trouver les échelles de gain »</translation>
    </message>
    <message>
        <source>find the sender that fills it, on the Bus page or with &apos;motorbenchctl monitor&apos;</source>
        <translation>trouver l’émetteur qui le sature, dans la page Bus ou avec «&#xa0;motorbenchctl monitor&#xa0;»</translation>
    </message>
    <message>
        <source>firmware update</source>
        <translation>mise à jour du firmware</translation>
    </message>
    <message>
        <source>firmware: %1</source>
        <translation>firmware&#xa0;: %1</translation>
    </message>
    <message>
        <source>follow needs the number of a device</source>
        <translation>le suivi demande le numéro d’un appareil</translation>
    </message>
    <message>
        <source>form error</source>
        <translation>erreur de format</translation>
    </message>
    <message>
        <source>found on %1</source>
        <translation>trouvé sur %1</translation>
    </message>
    <message>
        <source>free the shaft and see that no brake is on, then test again</source>
        <translation>libérez l’arbre et vérifiez qu’aucun frein n’est serré, puis testez à nouveau</translation>
    </message>
    <message>
        <source>frequency response: %1</source>
        <translation>réponse fréquentielle&#xa0;: %1</translation>
    </message>
    <message>
        <source>friction takes %1 duty of pushes of %2</source>
        <translation>le frottement prend %1 de rapport cyclique sur des poussées de %2</translation>
    </message>
    <message>
        <source>friction takes %1 of what P makes of a step, at most 60 %</source>
        <translation>le frottement prend %1 de ce que P tire d’un échelon, au plus 60 %</translation>
    </message>
    <message>
        <source>gave no sign after the stop</source>
        <translation>n’a pas donné signe après l’arrêt</translation>
    </message>
    <message>
        <source>gave no sign after the stop; its own watchdog switches it off</source>
        <translation>n’a pas donné signe après l’arrêt&#x202f;; son propre chien de garde le coupe</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>indiquez %1</translation>
    </message>
    <message>
        <source>keep what is tried, or name a notebook that can be written</source>
        <translation>gardez ce qui est essayé, ou indiquez un carnet dans lequel on peut écrire</translation>
    </message>
    <message>
        <source>give it a longer time</source>
        <translation>donnez-lui plus de temps</translation>
    </message>
    <message>
        <source>give a name that ends in .png, .svg or .pdf</source>
        <translation>indiquez un nom qui finit par .png, .svg ou .pdf</translation>
    </message>
    <message>
        <source>give a recording, or --help for what else there is</source>
        <translation>indiquez un enregistrement, ou --help pour le reste</translation>
    </message>
    <message>
        <source>give another target</source>
        <translation>indiquez une autre cible</translation>
    </message>
    <message>
        <source>give at least %1 s</source>
        <translation>indiquez au moins %1 s</translation>
    </message>
    <message>
        <source>give it a new one, or switch it off and on</source>
        <translation>donnez-lui-en un nouveau, ou éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>give it a number first, or take the self-test out of the recipe</source>
        <translation>donnez-lui d’abord un numéro, ou retirez l’autotest de la recette</translation>
    </message>
    <message>
        <source>gpiodetect lists those there are</source>
        <translation>gpiodetect énumère ceux qui existent</translation>
    </message>
    <message>
        <source>identify it anew</source>
        <translation>identifiez-le à nouveau</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit runs %3, bootloader %4</source>
        <translation>image %1 de %2 pages, l’appareil exécute %3, bootloader %4</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit without application, bootloader %3</source>
        <translation>image %1 de %2 pages, appareil sans application, bootloader %3</translation>
    </message>
    <message>
        <source>in bootloader %1, session kept</source>
        <translation>dans le bootloader %1, session conservée</translation>
    </message>
    <message>
        <source>in position mode a new counter would make the motor jump</source>
        <translation>en mode position, un nouveau compte ferait sauter le moteur</translation>
    </message>
    <message>
        <source>install %1</source>
        <translation>installez %1</translation>
    </message>
    <message>
        <source>install it with</source>
        <translation>installez-le avec</translation>
    </message>
    <message>
        <source>install its vendor&apos;s driver</source>
        <translation>installez le pilote de son fabricant</translation>
    </message>
    <message>
        <source>install the package that has it and try again</source>
        <translation>installez le paquet qui le contient et réessayez</translation>
    </message>
    <message>
        <source>installed are: %1</source>
        <translation>installés&#xa0;: %1</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>est un répertoire</translation>
    </message>
    <message>
        <source>is back</source>
        <translation>est de retour</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>a disparu</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>dépasse %1 octets</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is there</source>
        <translation>est là</translation>
    </message>
    <message>
        <source>it begins with &quot;recipe&quot;: 1</source>
        <translation>elle commence par &quot;recipe&quot;: 1</translation>
    </message>
    <message>
        <source>it begins with {</source>
        <translation>elle commence par {</translation>
    </message>
    <message>
        <source>it came to rest %1 of the step away from its target</source>
        <translation>il s’est immobilisé à %1 de l’échelon de sa cible</translation>
    </message>
    <message>
        <source>it cannot be tried</source>
        <translation>il ne peut pas être essayé</translation>
    </message>
    <message>
        <source>it cannot be written (system error %1)</source>
        <translation>écriture impossible (erreur système %1)</translation>
    </message>
    <message>
        <source>it did not come back</source>
        <translation>il n’est pas revenu</translation>
    </message>
    <message>
        <source>it did not settle</source>
        <translation>il ne s’est pas stabilisé</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>il a %1</translation>
    </message>
    <message>
        <source>it is a Vector BLF log</source>
        <translation>c’est un journal Vector BLF</translation>
    </message>
    <message>
        <source>it is a disk</source>
        <translation>c’est un disque</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>it is a recording</source>
        <translation>c’est un enregistrement</translation>
    </message>
    <message>
        <source>it is not known how to stop this device from outside</source>
        <translation>on ne sait pas comment arrêter cet appareil de l’extérieur</translation>
    </message>
    <message>
        <source>it is not proven which codes it speaks, and a stop of others may start it</source>
        <translation>il n’est pas prouvé quels codes il parle, et un arrêt avec d’autres pourrait le démarrer</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks</source>
        <translation>il n’est pas prouvé quels codes parle ce variateur</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks, and the wrong ones start it at full power</source>
        <translation>il n’est pas prouvé quels codes parle ce variateur, et les mauvais le démarrent à pleine puissance</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its integral</source>
        <translation>il peut s’arrêter à %1 de sa cible, moins ne fait pas bouger son intégrale</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its motor</source>
        <translation>il peut s’arrêter à %1 de sa cible, moins ne fait pas bouger son moteur</translation>
    </message>
    <message>
        <source>it overshot by %1, predicted were %2</source>
        <translation>il a dépassé de %1, %2 était prédit</translation>
    </message>
    <message>
        <source>it swung itself up with P %1 and D %2</source>
        <translation>il s’est mis à osciller avec P %1 et D %2</translation>
    </message>
    <message>
        <source>it took %1 to settle, predicted were %2</source>
        <translation>il a mis %1 à se stabiliser, %2 était prédit</translation>
    </message>
    <message>
        <source>it took longer than 1.5 × %1 s</source>
        <translation>il a duré plus de 1,5 × %1 s</translation>
    </message>
    <message>
        <source>it was put aside as %1, and what it kept of the device is unknown again</source>
        <translation>il a été mis de côté sous %1, et ce qu’il retenait de l’appareil est de nouveau inconnu</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>il a été arrêté</translation>
    </message>
    <message>
        <source>it would stop %1 counts from the start, %2 are allowed</source>
        <translation>il s’arrêterait à %1 counts du départ, %2 sont permis</translation>
    </message>
    <message>
        <source>its P or its position is not known, so whether this step overflows its loop is not either</source>
        <translation>son P ou sa position n’est pas connu, on ignore donc si cet échelon fait déborder sa boucle</translation>
    </message>
    <message>
        <source>its address is not a number</source>
        <translation>son adresse n’est pas un nombre</translation>
    </message>
    <message>
        <source>its dialect is not known</source>
        <translation>son dialecte n’est pas connu</translation>
    </message>
    <message>
        <source>its dialect is not known yet</source>
        <translation>son dialecte n’est pas encore connu</translation>
    </message>
    <message>
        <source>its dialect is not known, so no move can be sent</source>
        <translation>son dialecte n’est pas connu, donc aucun mouvement ne peut être envoyé</translation>
    </message>
    <message>
        <source>its error level is 1, which makes every reading fail: set error.level to 0</source>
        <translation>son niveau d’erreur est 1, ce qui fait échouer chaque lecture&#xa0;: mettez error.level à 0</translation>
    </message>
    <message>
        <source>its motor is turning or driven already</source>
        <translation>son moteur tourne ou est déjà piloté</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>sa position n’est pas encore connue</translation>
    </message>
    <message>
        <source>its profile is not known, so a move that passes its target could not be told</source>
        <translation>son profil n’est pas connu, un mouvement dépassant sa cible ne serait donc pas détecté</translation>
    </message>
    <message>
        <source>its reader has gone</source>
        <translation>son lecteur a disparu</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>connus&#xa0;: %1</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>omettez-le</translation>
    </message>
    <message>
        <source>leave out --target</source>
        <translation>omettez --target</translation>
    </message>
    <message>
        <source>leave out erasing them</source>
        <translation>omettez leur effacement</translation>
    </message>
    <message>
        <source>leave out interface=</source>
        <translation>omettez interface=</translation>
    </message>
    <message>
        <source>leave the other way in out</source>
        <translation>omettez l’autre accès</translation>
    </message>
    <message>
        <source>leave the target out</source>
        <translation>omettez la cible</translation>
    </message>
    <message>
        <source>legal is %1</source>
        <translation>valeurs admises %1</translation>
    </message>
    <message>
        <source>legal is 0.01 … 1000, or max</source>
        <translation>valeurs admises 0.01 … 1000, ou max</translation>
    </message>
    <message>
        <source>legal is 1 … 500</source>
        <translation>valeurs admises 1 … 500</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>limite %1</translation>
    </message>
    <message>
        <source>limits %1 … %2</source>
        <translation>limites %1 … %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>line %1 is neither a line of candump -L nor the beginning of a Vector ASC log</source>
        <translation>la ligne %1 n’est ni une ligne de candump -L ni le début d’un journal Vector ASC</translation>
    </message>
    <message>
        <source>line %1 is not a line of a Vector ASC log</source>
        <translation>la ligne %1 n’est pas une ligne d’un journal Vector ASC</translation>
    </message>
    <message>
        <source>line %1 is not a line of candump -L</source>
        <translation>la ligne %1 n’est pas une ligne de candump -L</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>link option %1=%2 is out of range</source>
        <translation>l’option de liaison %1=%2 est hors plage</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>l’option de liaison «&#xa0;%1&#xa0;» n’est pas KEY=VALUE</translation>
    </message>
    <message>
        <source>link option bitrate=%1 is out of range</source>
        <translation>l’option de liaison bitrate=%1 est hors plage</translation>
    </message>
    <message>
        <source>listen-only: nothing can be sent</source>
        <translation>écoute seule&#xa0;: aucun envoi n’est possible</translation>
    </message>
    <message>
        <source>load it</source>
        <translation>le charger</translation>
    </message>
    <message>
        <source>look at brushes, plugs and leads, then test again</source>
        <translation>vérifiez balais, connecteurs et fils, puis testez à nouveau</translation>
    </message>
    <message>
        <source>look at it again</source>
        <translation>revoyez-le</translation>
    </message>
    <message>
        <source>look at the cable and test again</source>
        <translation>vérifiez le câble et testez à nouveau</translation>
    </message>
    <message>
        <source>look at the plug and the polarity of encoder and motor, then test again</source>
        <translation>vérifiez le connecteur et la polarité du codeur et du moteur, puis testez à nouveau</translation>
    </message>
    <message>
        <source>look at the wiring of the input</source>
        <translation>vérifiez le câblage de l’entrée</translation>
    </message>
    <message>
        <source>look for units again</source>
        <translation>recherchez à nouveau les appareils</translation>
    </message>
    <message>
        <source>look whether something brakes or limits the motor</source>
        <translation>vérifiez si quelque chose freine ou limite le moteur</translation>
    </message>
    <message>
        <source>looking at the status bit</source>
        <translation>examen du bit d’état</translation>
    </message>
    <message>
        <source>looking for position D</source>
        <translation>recherche de position D</translation>
    </message>
    <message>
        <source>looking for position I</source>
        <translation>recherche de position I</translation>
    </message>
    <message>
        <source>looking for position P</source>
        <translation>recherche de position P</translation>
    </message>
    <message>
        <source>looking for velocity I</source>
        <translation>recherche de vitesse I</translation>
    </message>
    <message>
        <source>looking for velocity P</source>
        <translation>recherche de vitesse P</translation>
    </message>
    <message>
        <source>lower the gains or the steps</source>
        <translation>réduisez les gains ou les échelons</translation>
    </message>
    <message>
        <source>made way for an order</source>
        <translation>a laissé la place à un ordre</translation>
    </message>
    <message>
        <source>make room in %1</source>
        <translation>libérez de l’espace dans %1</translation>
    </message>
    <message>
        <source>make room, or choose another place</source>
        <translation>libérez de l’espace, ou choisissez un autre emplacement</translation>
    </message>
    <message>
        <source>more bytes than the device announced</source>
        <translation>plus d’octets que l’appareil n’en annonçait</translation>
    </message>
    <message>
        <source>more columns than the first line has</source>
        <translation>plus de colonnes que la première ligne</translation>
    </message>
    <message>
        <source>more than 1000 channels</source>
        <translation>plus de 1000 voies</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>déplacez-le</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>nommez un fichier</translation>
    </message>
    <message>
        <source>name a firmware in the recipe</source>
        <translation>nommez un firmware dans la recette</translation>
    </message>
    <message>
        <source>name a recording</source>
        <translation>nommez un enregistrement</translation>
    </message>
    <message>
        <source>name another folder</source>
        <translation>nommez un autre dossier</translation>
    </message>
    <message>
        <source>name it by its number; &apos;motorbenchctl snapshots&apos; lists them</source>
        <translation>nommez-le par son numéro&#x202f;; «&#xa0;motorbenchctl snapshots&#xa0;» les énumère</translation>
    </message>
    <message>
        <source>name its serial port, for example --via serial:/dev/ttyUSB0</source>
        <translation>nommez son port série, par exemple --via serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one such as /dev/ttyUSB0</source>
        <translation>nommez-en un, par exemple /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one, such as sim:can</source>
        <translation>nommez-en une, par exemple sim:can</translation>
    </message>
    <message>
        <source>name one: %1 or %2</source>
        <translation>nommez-en un&#xa0;: %1 ou %2</translation>
    </message>
    <message>
        <source>no %1 answers as number %2 on %3</source>
        <translation>aucun %1 ne répond sous le numéro %2 sur %3</translation>
    </message>
    <message>
        <source>no %1 sends as number %2 in %3</source>
        <translation>aucun %1 n’envoie sous le numéro %2 dans %3</translation>
    </message>
    <message>
        <source>no CAN frame: its identifier or size is out of range</source>
        <translation>pas une trame CAN&#xa0;: son identifiant ou sa taille est hors plage</translation>
    </message>
    <message>
        <source>no D was found with which a small P neither swings nor creeps</source>
        <translation>aucun D n’a été trouvé avec lequel un petit P ni n’oscille ni ne rampe</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>pas de réponse</translation>
    </message>
    <message>
        <source>no application runs in this unit</source>
        <translation>aucune application ne tourne dans cet appareil</translation>
    </message>
    <message>
        <source>no bootloader answers at %1 bit/s</source>
        <translation>aucun bootloader ne répond à %1 bit/s</translation>
    </message>
    <message>
        <source>no data in page 0 (0x00000-0x00FFF), the file is not a whole application</source>
        <translation>aucune donnée dans la page 0 (0x00000-0x00FFF), le fichier n’est pas une application complète</translation>
    </message>
    <message>
        <source>no data in page 30 (0x1E000-0x1EFFF), where the version is</source>
        <translation>aucune donnée dans la page 30 (0x1E000-0x1EFFF), où se trouve la version</translation>
    </message>
    <message>
        <source>no experiment: %1</source>
        <translation>pas d’expérience&#xa0;: %1</translation>
    </message>
    <message>
        <source>no gain of the position loop turns the motor</source>
        <translation>aucun gain de la boucle de position ne fait tourner le moteur</translation>
    </message>
    <message>
        <source>no gain of the velocity loop turns the motor</source>
        <translation>aucun gain de la boucle de vitesse ne fait tourner le moteur</translation>
    </message>
    <message>
        <source>no guardian came within two seconds</source>
        <translation>aucun gardien n’est venu en deux secondes</translation>
    </message>
    <message>
        <source>no guardian can be started: %1</source>
        <translation>aucun gardien ne peut être démarré&#xa0;: %1</translation>
    </message>
    <message>
        <source>no history is kept here</source>
        <translation>aucun historique n’est tenu ici</translation>
    </message>
    <message>
        <source>no instruction at the entry point 0x00400</source>
        <translation>aucune instruction au point d’entrée 0x00400</translation>
    </message>
    <message>
        <source>no number: server silent</source>
        <translation>pas de numéro&#xa0;: serveur muet</translation>
    </message>
    <message>
        <source>no object at the top</source>
        <translation>pas d’objet au niveau supérieur</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here</source>
        <translation>pas d’autorisation pour ouvrir des sockets CAN ici</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>pas d’autorisation pour le lire</translation>
    </message>
    <message>
        <source>no permission to use %1</source>
        <translation>pas d’autorisation pour utiliser %1</translation>
    </message>
    <message>
        <source>no permission to write there</source>
        <translation>pas d’autorisation pour y écrire</translation>
    </message>
    <message>
        <source>no pseudo terminal can be had: %1</source>
        <translation>aucun pseudo-terminal disponible&#xa0;: %1</translation>
    </message>
    <message>
        <source>no push met the current limit</source>
        <translation>aucune poussée n’a atteint la limite de courant</translation>
    </message>
    <message>
        <source>no ready line is wired</source>
        <translation>aucune ligne prêt n’est câblée</translation>
    </message>
    <message>
        <source>no reset line is wired</source>
        <translation>aucune ligne de reset n’est câblée</translation>
    </message>
    <message>
        <source>no sample for %1</source>
        <translation>pas d’échantillon pendant %1</translation>
    </message>
    <message>
        <source>no snapshot of what was found: %1</source>
        <translation>pas d’instantané de l’état trouvé&#xa0;: %1</translation>
    </message>
    <message>
        <source>no snapshot of what was there: %1</source>
        <translation>pas d’instantané de l’état précédent&#xa0;: %1</translation>
    </message>
    <message>
        <source>no snapshot: %1</source>
        <translation>pas d’instantané&#xa0;: %1</translation>
    </message>
    <message>
        <source>no snapshots are kept here</source>
        <translation>aucun instantané n’est tenu ici</translation>
    </message>
    <message>
        <source>no status within 2 s</source>
        <translation>pas d’état en 2 s</translation>
    </message>
    <message>
        <source>no step met the end of the output</source>
        <translation>aucun échelon n’a atteint la butée de la sortie</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>fichier introuvable</translation>
    </message>
    <message>
        <source>no version at 0x1EFFC</source>
        <translation>pas de version à 0x1EFFC</translation>
    </message>
    <message>
        <source>nobody acknowledged</source>
        <translation>personne n’a acquitté</translation>
    </message>
    <message>
        <source>nobody acknowledges what %1 sends</source>
        <translation>personne n’acquitte ce que %1 envoie</translation>
    </message>
    <message>
        <source>nobody reads from this pipe</source>
        <translation>personne ne lit ce tube</translation>
    </message>
    <message>
        <source>nobody renewed the motion lease</source>
        <translation>l’autorisation de mouvement n’a pas été renouvelée</translation>
    </message>
    <message>
        <source>nobody serves %1</source>
        <translation>personne ne sert %1</translation>
    </message>
    <message>
        <source>nobody watches over this self-test, and it moves the motor</source>
        <translation>personne ne surveille cet autotest, et il fait tourner le moteur</translation>
    </message>
    <message>
        <source>node %1 does not answer</source>
        <translation>le nœud %1 ne répond pas</translation>
    </message>
    <message>
        <source>node id %1 is used by another node of this line</source>
        <translation>l’id de nœud %1 est utilisé par un autre nœud de cette ligne</translation>
    </message>
    <message>
        <source>not a parameter file: %1</source>
        <translation>pas un fichier de paramètres&#xa0;: %1</translation>
    </message>
    <message>
        <source>not a parameter file: it has no &quot;parameters&quot;</source>
        <translation>pas un fichier de paramètres&#xa0;: il n’a pas de «&#xa0;parameters&#xa0;»</translation>
    </message>
    <message>
        <source>not sent: %1 for %2</source>
        <translation>non envoyé&#xa0;: %1 pour %2</translation>
    </message>
    <message>
        <source>not sent: %1 outside the controller&apos;s flash</source>
        <translation>non envoyé&#xa0;: %1 hors de la flash du contrôleur</translation>
    </message>
    <message>
        <source>not sent: %1 where a 24-bit instruction has none, the file may be for another processor</source>
        <translation>non envoyé&#xa0;: %1 là où une instruction de 24 bits n’en a pas&#x202f;; le fichier est peut-être pour un autre processeur</translation>
    </message>
    <message>
        <source>nothing could put the gains back after a crash</source>
        <translation>rien ne pourrait rétablir les gains après un plantage</translation>
    </message>
    <message>
        <source>nothing has been recorded yet</source>
        <translation>rien n’a encore été enregistré</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>rien à envoyer</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>rien n’a été mesuré</translation>
    </message>
    <message>
        <source>nothing was saved</source>
        <translation>rien n’a été sauvegardé</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>rien n’a été écrit</translation>
    </message>
    <message>
        <source>nothing was written; the image fits, %1 pages</source>
        <translation>rien n’a été écrit&#x202f;; l’image convient, %1 pages</translation>
    </message>
    <message>
        <source>now the calm ones</source>
        <translation>maintenant les calmes</translation>
    </message>
    <message>
        <source>number %1 is used by another unit</source>
        <translation>le numéro %1 est utilisé par un autre appareil</translation>
    </message>
    <message>
        <source>number %1 still keeps a move that was stopped before it began, and would begin it too</source>
        <translation>le numéro %1 garde encore un mouvement arrêté avant d’avoir commencé, et le lancerait aussi</translation>
    </message>
    <message>
        <source>one more would make the drive load something else. Erase its settings pages with a firmware update (erase settings), then save again</source>
        <translation>une fois de plus et le variateur chargerait autre chose. Effacez ses pages de réglages par une mise à jour du firmware (effacer les réglages), puis mémorisez à nouveau</translation>
    </message>
    <message>
        <source>one update a bus: %1 is being written; nothing was sent</source>
        <translation>une seule mise à jour par bus&#xa0;: écriture de %1 en cours&#x202f;; rien n’a été envoyé</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate</source>
        <translation>seules des trames perturbées arrivent sur %1, le bus a un autre débit</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate than %2</source>
        <translation>seules des trames perturbées arrivent sur %1, le bus a un autre débit que %2</translation>
    </message>
    <message>
        <source>only its power stops it</source>
        <translation>seule la coupure d’alimentation l’arrête</translation>
    </message>
    <message>
        <source>only those are recorded</source>
        <translation>seules celles-ci sont enregistrées</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>rouvrez-le</translation>
    </message>
    <message>
        <source>open that terminal as serial:%1</source>
        <translation>ouvrez ce terminal comme serial:%1</translation>
    </message>
    <message>
        <source>open the link that it was made on</source>
        <translation>ouvrez la liaison sur laquelle il a été fait</translation>
    </message>
    <message>
        <source>openocd is not installed</source>
        <translation>openocd n’est pas installé</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>l’option «&#xa0;%1&#xa0;» n’est pas CLÉ=VALEUR</translation>
    </message>
    <message>
        <source>page %1 accepted with CRC variant %2</source>
        <translation>page %1 acceptée avec la variante de CRC %2</translation>
    </message>
    <message>
        <source>page %1 cannot be written: its flash failed the device&apos;s own check %2 times</source>
        <translation>impossible d’écrire la page %1&#xa0;: sa flash a échoué %2 fois au contrôle de l’appareil</translation>
    </message>
    <message>
        <source>page %1 was not accepted in %2 tries</source>
        <translation>page %1 non acceptée en %2 tentatives</translation>
    </message>
    <message>
        <source>page %1 was said to be written before its bytes can have arrived</source>
        <translation>la page %1 a été déclarée écrite avant que ses octets aient pu arriver</translation>
    </message>
    <message>
        <source>page %1: %2, sent again</source>
        <translation>page %1&#xa0;: %2, renvoyée</translation>
    </message>
    <message>
        <source>page 0: its status was lost, but the version is there; it is not written again</source>
        <translation>page 0&#xa0;: son état a été perdu, mais la version est là&#x202f;; elle n’est pas réécrite</translation>
    </message>
    <message>
        <source>pages 31-34 (configuration and descriptors)</source>
        <translation>pages 31-34 (configuration et descripteurs)</translation>
    </message>
    <message>
        <source>pages 35-42 (bootloader and flash configuration)</source>
        <translation>pages 35-42 (bootloader et configuration de la flash)</translation>
    </message>
    <message>
        <source>parameters that were changed last may be lost: %1</source>
        <translation>les derniers paramètres modifiés peuvent être perdus&#xa0;: %1</translation>
    </message>
    <message>
        <source>pause=%1: legal are 0 to 1000 milliseconds</source>
        <translation>pause=%1&#xa0;: valeurs admises 0 à 1000 millisecondes</translation>
    </message>
    <message>
        <source>plug in an adapter</source>
        <translation>brancher un adaptateur</translation>
    </message>
    <message>
        <source>plug in an adapter at any time; it is opened by itself once it is up</source>
        <translation>branchez un adaptateur à tout moment&#x202f;; il s’ouvre de lui-même dès qu’il est actif</translation>
    </message>
    <message>
        <source>plug in the adapter, or name another port</source>
        <translation>branchez l’adaptateur, ou nommez un autre port</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>rebranchez-le</translation>
    </message>
    <message>
        <source>plug one in</source>
        <translation>branchez-en un</translation>
    </message>
    <message>
        <source>plug the adapter in again; the link is opened by itself as soon as it is up</source>
        <translation>rebranchez l’adaptateur&#x202f;; la liaison s’ouvre d’elle-même dès qu’il est actif</translation>
    </message>
    <message>
        <source>polarity 0 is active high: the board follows the maker&apos;s library</source>
        <translation>la polarité 0 est active à l’état haut&#xa0;: la carte suit la bibliothèque du fabricant</translation>
    </message>
    <message>
        <source>polarity 0 is active low: the board follows the data sheet</source>
        <translation>la polarité 0 est active à l’état bas&#xa0;: la carte suit la fiche technique</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is active</source>
        <translation>bit de polarité %1&#xa0;: l’entrée est active</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is not active</source>
        <translation>bit de polarité %1&#xa0;: l’entrée n’est pas active</translation>
    </message>
    <message>
        <source>position D has no effect that could be measured; its scale stays unknown</source>
        <translation>position D n’a pas d’effet mesurable&#x202f;; son échelle reste inconnue</translation>
    </message>
    <message>
        <source>position has 32 bits</source>
        <translation>la position a 32 bits</translation>
    </message>
    <message>
        <source>power %1: %2 and %3 counts/s</source>
        <translation>puissance %1&#xa0;: %2 et %3 counts/s</translation>
    </message>
    <message>
        <source>protocol error</source>
        <translation>erreur de protocole</translation>
    </message>
    <message>
        <source>proving: a step of %1 A</source>
        <translation>vérification&#xa0;: un échelon de %1 A</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts</source>
        <translation>vérification&#xa0;: un échelon de %1 counts</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts/s</source>
        <translation>vérification&#xa0;: un échelon de %1 counts/s</translation>
    </message>
    <message>
        <source>pty links have the option baud=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>les liaisons pty ont l’option baud=BITS_PAR_SECONDE, pas «&#xa0;%1=%2&#xa0;»</translation>
    </message>
    <message>
        <source>pty: is where &apos;simulate&apos; puts its devices</source>
        <translation>pty: est l’endroit où «&#xa0;simulate&#xa0;» place ses appareils</translation>
    </message>
    <message>
        <source>push harder or longer</source>
        <translation>poussez plus fort ou plus longtemps</translation>
    </message>
    <message>
        <source>push longer, or ask for faster samples</source>
        <translation>poussez plus longtemps, ou demandez des échantillons plus rapides</translation>
    </message>
    <message>
        <source>push with two sizes</source>
        <translation>poussez avec deux amplitudes</translation>
    </message>
    <message>
        <source>pushes of one size do not tell friction from gain</source>
        <translation>des poussées d’une seule amplitude ne distinguent pas frottement et gain</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s</source>
        <translation>poussée à %1 de rapport cyclique pendant %2 s</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s, %3 times</source>
        <translation>poussée à %1 de rapport cyclique pendant %2 s, %3 fois</translation>
    </message>
    <message>
        <source>putting the settings back</source>
        <translation>rétablissement des réglages</translation>
    </message>
    <message>
        <source>qtcan links have the option bitrate=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>les liaisons qtcan ont l’option bitrate=BITS_PAR_SECONDE, pas «&#xa0;%1=%2&#xa0;»</translation>
    </message>
    <message>
        <source>read gain.p</source>
        <translation>lisez gain.p</translation>
    </message>
    <message>
        <source>read it again</source>
        <translation>relisez-le</translation>
    </message>
    <message>
        <source>read it first</source>
        <translation>lisez-le d’abord</translation>
    </message>
    <message>
        <source>read profile.velocity and profile.acceleration</source>
        <translation>lisez profile.velocity et profile.acceleration</translation>
    </message>
    <message>
        <source>recessive bit not sent</source>
        <translation>bit récessif non envoyé</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>reconnecter</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>enregistrez à nouveau</translation>
    </message>
    <message>
        <source>record type %1 is unknown</source>
        <translation>le type d’enregistrement %1 est inconnu</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>refusé&#xa0;: %1</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>supprimez-le</translation>
    </message>
    <message>
        <source>remove it, or make it readable</source>
        <translation>supprimez-le, ou rendez-le lisible</translation>
    </message>
    <message>
        <source>remove the cause, then test again</source>
        <translation>supprimez la cause, puis testez à nouveau</translation>
    </message>
    <message>
        <source>replay links have no option &apos;%1&apos;</source>
        <translation>les liaisons replay n’ont pas d’option «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>residual %1 of what counts and clocks explain, at most 3</source>
        <translation>résidu %1 de ce qu’expliquent compteurs et horloges, au plus 3</translation>
    </message>
    <message>
        <source>restarted, the application answers</source>
        <translation>redémarré, l’application répond</translation>
    </message>
    <message>
        <source>run avrdude by hand to see all it says</source>
        <translation>exécutez avrdude à la main pour voir tout ce qu’il dit</translation>
    </message>
    <message>
        <source>run it by hand to see all it says</source>
        <translation>exécutez-le à la main pour voir tout ce qu’il dit</translation>
    </message>
    <message>
        <source>run it by hand with -c %1</source>
        <translation>exécutez-le à la main avec -c %1</translation>
    </message>
    <message>
        <source>run it by hand with interface %1</source>
        <translation>exécutez-le à la main avec l’interface %1</translation>
    </message>
    <message>
        <source>sample point %1 %</source>
        <translation>point d’échantillonnage %1 %</translation>
    </message>
    <message>
        <source>save it as ASC and take that</source>
        <translation>sauvegardez-le en ASC et utilisez celui-ci</translation>
    </message>
    <message>
        <source>scan again, or choose its dialect by hand</source>
        <translation>relancez la recherche, ou choisissez son dialecte à la main</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe, then test again</source>
        <translation>vérifiez que moteur et charge sont ceux de la recette, puis testez à nouveau</translation>
    </message>
    <message>
        <source>see that nothing is loose and that steps look alike</source>
        <translation>vérifiez que rien n’est desserré et que les échelons se ressemblent</translation>
    </message>
    <message>
        <source>see that nothing is loose, and write gains once with which it comes to rest</source>
        <translation>vérifiez que rien n’est desserré, et écrivez une fois des gains avec lesquels il se stabilise</translation>
    </message>
    <message>
        <source>see that nothing is loose; a stronger load than it was built for cannot be tuned</source>
        <translation>vérifiez que rien n’est desserré&#x202f;; une charge plus forte que prévu ne peut pas être réglée</translation>
    </message>
    <message>
        <source>see that the motor is connected</source>
        <translation>vérifiez que le moteur est raccordé</translation>
    </message>
    <message>
        <source>see that the server runs; entries wait here until it does</source>
        <translation>vérifiez que le serveur tourne&#x202f;; d’ici là, les entrées patientent ici</translation>
    </message>
    <message>
        <source>see that this is the motor and the encoder of the recipe, then test again</source>
        <translation>vérifiez que ce sont le moteur et le codeur de la recette, puis testez à nouveau</translation>
    </message>
    <message>
        <source>see whether a load always pulls one way</source>
        <translation>vérifiez si une charge tire toujours dans un sens</translation>
    </message>
    <message>
        <source>see whether brushes and plugs make contact</source>
        <translation>vérifiez que balais et connecteurs font contact</translation>
    </message>
    <message>
        <source>select a longer stretch</source>
        <translation>sélectionnez un intervalle plus long</translation>
    </message>
    <message>
        <source>sending the firmware</source>
        <translation>envoi du firmware</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>numéro de série %1</translation>
    </message>
    <message>
        <source>service</source>
        <translation>intervention</translation>
    </message>
    <message>
        <source>several units answer as number %1</source>
        <translation>plusieurs appareils répondent sous le numéro %1</translation>
    </message>
    <message>
        <source>several units answer under this number in the recording</source>
        <translation>plusieurs appareils répondent sous ce numéro dans l’enregistrement</translation>
    </message>
    <message>
        <source>several units have a snapshot &apos;%1&apos;</source>
        <translation>plusieurs appareils ont un instantané «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>sim: stands for several links</source>
        <translation>sim: désigne plusieurs liaisons</translation>
    </message>
    <message>
        <source>simulated links belong to a bench</source>
        <translation>les liaisons simulées appartiennent à un banc</translation>
    </message>
    <message>
        <source>sine %1 of %2, %3 Hz: %4</source>
        <translation>sinus %1 sur %2, %3 Hz&#xa0;: %4</translation>
    </message>
    <message>
        <source>snapshot %1, %2: %3 values</source>
        <translation>instantané %1, %2&#xa0;: %3 valeurs</translation>
    </message>
    <message>
        <source>socketcan links have no option &apos;%1&apos;</source>
        <translation>les liaisons socketcan n’ont pas d’option «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>somebody may have started it again, so the position was not reset</source>
        <translation>quelqu’un l’a peut-être redémarré, donc la position n’a pas été remise à zéro</translation>
    </message>
    <message>
        <source>something follows the end-of-file record</source>
        <translation>quelque chose suit l’enregistrement de fin de fichier</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>speed %1 counts/s is above 1.2 × %2 counts/s</source>
        <translation>la vitesse %1 counts/s est supérieure à 1,2 × %2 counts/s</translation>
    </message>
    <message>
        <source>speed is 10000 to 10000000 Hz, not &apos;%1&apos;</source>
        <translation>speed va de 10000 à 10000000 Hz, pas «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>speed, ready and reset are known</source>
        <translation>connus&#xa0;: speed, ready et reset</translation>
    </message>
    <message>
        <source>speed=%1 is no speed</source>
        <translation>speed=%1 n’est pas une vitesse</translation>
    </message>
    <message>
        <source>spidev links have no option &apos;%1&apos;</source>
        <translation>les liaisons spidev n’ont pas d’option «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>stalled, or the encoder is dead: less than 3 counts in %1</source>
        <translation>bloqué, ou le codeur est mort&#xa0;: moins de 3 counts en %1</translation>
    </message>
    <message>
        <source>start it again</source>
        <translation>redémarrez-le</translation>
    </message>
    <message>
        <source>start the reader first</source>
        <translation>démarrez d’abord le lecteur</translation>
    </message>
    <message>
        <source>start the simulator again</source>
        <translation>redémarrez le simulateur</translation>
    </message>
    <message>
        <source>start the simulator first</source>
        <translation>démarrez d’abord le simulateur</translation>
    </message>
    <message>
        <source>steps with one pair of gains only do not tell what each of them does</source>
        <translation>des échelons avec une seule paire de gains n’indiquent pas ce que fait chacun</translation>
    </message>
    <message>
        <source>stop it before its gains are put back</source>
        <translation>arrêtez-le avant de rétablir ses gains</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>arrêtez-le d’abord</translation>
    </message>
    <message>
        <source>stop it there first</source>
        <translation>arrêtez-le d’abord là-bas</translation>
    </message>
    <message>
        <source>stop it, then put the values back</source>
        <translation>arrêtez-le, puis rétablissez les valeurs</translation>
    </message>
    <message>
        <source>stop the motor before an experiment begins</source>
        <translation>arrêtez le moteur avant le début d’une expérience</translation>
    </message>
    <message>
        <source>stop the motor before its dialect is changed</source>
        <translation>arrêtez le moteur avant de changer son dialecte</translation>
    </message>
    <message>
        <source>stop the motor first</source>
        <translation>arrêtez d’abord le moteur</translation>
    </message>
    <message>
        <source>stop the motor first: the drive stands still while it writes its flash</source>
        <translation>arrêtez d’abord le moteur&#xa0;: le variateur s’immobilise pendant l’écriture de sa flash</translation>
    </message>
    <message>
        <source>stop the motors before settings are written again</source>
        <translation>arrêtez les moteurs avant de réécrire les réglages</translation>
    </message>
    <message>
        <source>stop the motors first</source>
        <translation>arrêtez d’abord les moteurs</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>arrêté</translation>
    </message>
    <message>
        <source>stopped while it waited for a number</source>
        <translation>arrêté pendant l’attente d’un numéro</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>arrêté&#xa0;: %1</translation>
    </message>
    <message>
        <source>stopped: the window did not respond in time</source>
        <translation>arrêté&#xa0;: la fenêtre n’a pas répondu à temps</translation>
    </message>
    <message>
        <source>stored, not verifiable</source>
        <translation>mémorisé, non vérifiable</translation>
    </message>
    <message>
        <source>stuff error</source>
        <translation>erreur de bourrage</translation>
    </message>
    <message>
        <source>such a line reads %1</source>
        <translation>une telle ligne s’écrit %1</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>par exemple %1</translation>
    </message>
    <message>
        <source>supply %1 V is outside %2 … %3 V</source>
        <translation>l’alimentation %1 V est hors de %2 … %3 V</translation>
    </message>
    <message>
        <source>switch it off and on</source>
        <translation>éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1</source>
        <translation>mettre les appareils sous tension, vérifier le câble, que deux résistances de 120 Ω terminent le bus et que chaque appareil a le débit %1</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate of this interface</source>
        <translation>mettez les appareils sous tension, vérifiez le câble, que deux résistances de 120 Ω terminent le bus et que chaque appareil a le débit de cette interface</translation>
    </message>
    <message>
        <source>take a finer encoder or a calmer loop</source>
        <translation>prenez un codeur plus fin ou une boucle plus calme</translation>
    </message>
    <message>
        <source>take a smaller step or widen it</source>
        <translation>prenez un échelon plus petit ou élargissez-la</translation>
    </message>
    <message>
        <source>take one of them</source>
        <translation>prenez l’un d’eux</translation>
    </message>
    <message>
        <source>take the jumper out and reset it</source>
        <translation>retirez le cavalier et réinitialisez-la</translation>
    </message>
    <message>
        <source>take the jumper out; the board is asked for its version</source>
        <translation>retirez le cavalier&#x202f;; la version est demandée à la carte</translation>
    </message>
    <message>
        <source>take the other one off, or give one of them another number</source>
        <translation>retirez l’autre, ou donnez un autre numéro à l’un d’eux</translation>
    </message>
    <message>
        <source>temperature %1 °C is within 5 K of %2 °C</source>
        <translation>la température %1 °C est à moins de 5 K de %2 °C</translation>
    </message>
    <message>
        <source>test again when it is safe</source>
        <translation>testez à nouveau quand c’est sans danger</translation>
    </message>
    <message>
        <source>the %1 gains did not: %2</source>
        <translation>les gains «&#xa0;%1&#xa0;» ne l’ont pas fait&#xa0;: %2</translation>
    </message>
    <message>
        <source>the %1 loop was saved %2 times; after %3 its settings pages must be erased</source>
        <translation>la boucle %1 a été mémorisée %2 fois&#x202f;; après %3, ses pages de réglages doivent être effacées</translation>
    </message>
    <message>
        <source>the acknowledge delimiter</source>
        <translation>le délimiteur d’acquittement</translation>
    </message>
    <message>
        <source>the acknowledge slot</source>
        <translation>le slot d’acquittement</translation>
    </message>
    <message>
        <source>the answer to the reset was lost; found again by enumeration</source>
        <translation>la réponse au reset a été perdue&#x202f;; retrouvé par énumération</translation>
    </message>
    <message>
        <source>the axis has a power limit of %1 %, which is kept</source>
        <translation>l’axe a une limite de puissance de %1 %, qui est respectée</translation>
    </message>
    <message>
        <source>the base of the numbers is %1, not hex or dec</source>
        <translation>la base des nombres est %1, pas hex ou dec</translation>
    </message>
    <message>
        <source>the board answered with an error that its documents do not name</source>
        <translation>la carte a répondu par une erreur que ses documents ne nomment pas</translation>
    </message>
    <message>
        <source>the board did not answer</source>
        <translation>la carte n’a pas répondu</translation>
    </message>
    <message>
        <source>the board did not tell its status</source>
        <translation>la carte n’a pas indiqué son état</translation>
    </message>
    <message>
        <source>the board does not know this command</source>
        <translation>la carte ne connaît pas cette commande</translation>
    </message>
    <message>
        <source>the board does not tell its position</source>
        <translation>la carte n’indique pas sa position</translation>
    </message>
    <message>
        <source>the board found the packet malformed</source>
        <translation>la carte a jugé le paquet mal formé</translation>
    </message>
    <message>
        <source>the board has axes 1 to 4</source>
        <translation>la carte a les axes 1 à 4</translation>
    </message>
    <message>
        <source>the board has no number: chip select tells boards apart</source>
        <translation>la carte n’a pas de numéro&#xa0;: le chip select distingue les cartes</translation>
    </message>
    <message>
        <source>the board has no such mode</source>
        <translation>la carte n’a pas ce mode</translation>
    </message>
    <message>
        <source>the board has one set of gains per axis</source>
        <translation>la carte a un jeu de gains par axe</translation>
    </message>
    <message>
        <source>the board is updated over its UART</source>
        <translation>la carte se met à jour par son UART</translation>
    </message>
    <message>
        <source>the board keeps nothing without power</source>
        <translation>la carte ne garde rien hors tension</translation>
    </message>
    <message>
        <source>the board may want velocity targets times 4096: choose that setting, and try again</source>
        <translation>la carte attend peut-être des consignes de vitesse multipliées par 4096&#xa0;: choisissez ce réglage, et réessayez</translation>
    </message>
    <message>
        <source>the board refused a value</source>
        <translation>la carte a refusé une valeur</translation>
    </message>
    <message>
        <source>the board restarted at %1</source>
        <translation>la carte a redémarré à %1</translation>
    </message>
    <message>
        <source>the board sent a reply without a return code</source>
        <translation>la carte a envoyé une réponse sans code de retour</translation>
    </message>
    <message>
        <source>the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven</source>
        <translation>la carte parle le protocole %1, ce programme a été écrit pour le protocole 1&#x202f;; observez-la avant de la piloter</translation>
    </message>
    <message>
        <source>the board was reset since its settings were written</source>
        <translation>la carte a été réinitialisée depuis l’écriture de ses réglages</translation>
    </message>
    <message>
        <source>the board was unplugged</source>
        <translation>la carte a été débranchée</translation>
    </message>
    <message>
        <source>the bootloader did not announce itself</source>
        <translation>le bootloader ne s’est pas annoncé</translation>
    </message>
    <message>
        <source>the bootloader refuses page %1</source>
        <translation>le bootloader refuse la page %1</translation>
    </message>
    <message>
        <source>the bootloader said nothing</source>
        <translation>le bootloader n’a rien dit</translation>
    </message>
    <message>
        <source>the bus leaves no room for what %1 sends</source>
        <translation>le bus ne laisse pas de place à ce que %1 envoie</translation>
    </message>
    <message>
        <source>the byte count was out of step</source>
        <translation>le nombre d’octets était décalé</translation>
    </message>
    <message>
        <source>the cable was pulled out</source>
        <translation>le câble a été débranché</translation>
    </message>
    <message>
        <source>the checksum</source>
        <translation>la somme de contrôle</translation>
    </message>
    <message>
        <source>the checksum delimiter</source>
        <translation>le délimiteur de la somme de contrôle</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>l’ordinateur était en veille</translation>
    </message>
    <message>
        <source>the controller lost frames to send</source>
        <translation>le contrôleur a perdu des trames à envoyer</translation>
    </message>
    <message>
        <source>the controller lost received frames</source>
        <translation>le contrôleur a perdu des trames reçues</translation>
    </message>
    <message>
        <source>the controller may hold half a program, and runs again once an update has succeeded</source>
        <translation>le contrôleur contient peut-être un demi-programme, et ne tournera à nouveau qu’après une mise à jour réussie</translation>
    </message>
    <message>
        <source>the controller started again</source>
        <translation>le contrôleur a redémarré</translation>
    </message>
    <message>
        <source>the current did not follow the duty, so its resistance is not known</source>
        <translation>le courant n’a pas suivi le rapport cyclique, sa résistance n’est donc pas connue</translation>
    </message>
    <message>
        <source>the current limit cut into the pushes</source>
        <translation>la limite de courant a tronqué les poussées</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>les données</translation>
    </message>
    <message>
        <source>the data masks have an unexpected length</source>
        <translation>les masques de données ont une longueur inattendue</translation>
    </message>
    <message>
        <source>the data runs past the end of 32-bit addresses</source>
        <translation>les données dépassent la fin des adresses de 32 bits</translation>
    </message>
    <message>
        <source>the data runs past the end of its 64 KiB segment</source>
        <translation>les données dépassent la fin de leur segment de 64 KiB</translation>
    </message>
    <message>
        <source>the device already runs %1</source>
        <translation>l’appareil exécute déjà %1</translation>
    </message>
    <message>
        <source>the device answers with no application</source>
        <translation>l’appareil répond sans application</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>l’appareil répond avec la version %1</translation>
    </message>
    <message>
        <source>the device could not verify its flash</source>
        <translation>l’appareil n’a pas pu vérifier sa flash</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>l’appareil ne répond pas</translation>
    </message>
    <message>
        <source>the device is busy with something else</source>
        <translation>l’appareil est occupé à autre chose</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>l’appareil a disparu</translation>
    </message>
    <message>
        <source>the device is not heard any more</source>
        <translation>l’appareil ne se fait plus entendre</translation>
    </message>
    <message>
        <source>the device may have restarted: once more from page %1</source>
        <translation>l’appareil a peut-être redémarré&#xa0;: reprise à partir de la page %1</translation>
    </message>
    <message>
        <source>the device restarted</source>
        <translation>l’appareil a redémarré</translation>
    </message>
    <message>
        <source>the device restarted %1 times during the update</source>
        <translation>l’appareil a redémarré %1 fois pendant la mise à jour</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written</source>
        <translation>l’appareil a redémarré avant que l’écriture de sa flash soit prouvée</translation>
    </message>
    <message>
        <source>the device says that the motor is not started; it may have lost its supply</source>
        <translation>l’appareil indique que le moteur n’est pas démarré&#x202f;; il a peut-être perdu son alimentation</translation>
    </message>
    <message>
        <source>the device&apos;s rate was not put back: %1</source>
        <translation>la cadence de l’appareil n’a pas été rétablie&#xa0;: %1</translation>
    </message>
    <message>
        <source>the disk has not made %1 within 10 s</source>
        <translation>le disque n’a pas créé %1 en 10 s</translation>
    </message>
    <message>
        <source>the disk has not taken %1 for 30 s</source>
        <translation>le disque n’a pas accepté %1 depuis 30 s</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>the disk of %1 does not answer</source>
        <translation>le disque de %1 ne répond pas</translation>
    </message>
    <message>
        <source>the drive does not check it and would overwrite its memory</source>
        <translation>le variateur ne le vérifie pas et écraserait sa mémoire</translation>
    </message>
    <message>
        <source>the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does</source>
        <translation>le pilote de %1 ne sait pas commuter le sens d’une ligne RS-485, l’adaptateur doit donc le faire lui-même&#x202f;; si rien ne répond, utilisez-en un qui le fait</translation>
    </message>
    <message>
        <source>the duty changed its direction %1 times in a second</source>
        <translation>le rapport cyclique a changé de sens %1 fois en une seconde</translation>
    </message>
    <message>
        <source>the encoder counts against the power</source>
        <translation>le codeur compte dans le sens opposé à la puissance</translation>
    </message>
    <message>
        <source>the encoder does not count both ways</source>
        <translation>le codeur ne compte pas dans les deux sens</translation>
    </message>
    <message>
        <source>the end of frame</source>
        <translation>la fin de trame</translation>
    </message>
    <message>
        <source>the end-of-file record is missing, the file may be cut off</source>
        <translation>l’enregistrement de fin de fichier manque, le fichier est peut-être tronqué</translation>
    </message>
    <message>
        <source>the file has no lines to send</source>
        <translation>le fichier n’a pas de lignes à envoyer</translation>
    </message>
    <message>
        <source>the file has reached the greatest size there</source>
        <translation>le fichier y a atteint la taille maximale</translation>
    </message>
    <message>
        <source>the file holds no data</source>
        <translation>le fichier ne contient aucune donnée</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>impossible de créer le dossier %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be written</source>
        <translation>impossible d’écrire dans le dossier %1</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>la formule est trop profondément imbriquée</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>la formule n’utilise aucun signal</translation>
    </message>
    <message>
        <source>the frame has %1 of %2 bytes</source>
        <translation>la trame a %1 octets sur %2</translation>
    </message>
    <message>
        <source>the frame is of the kind %1, not d or r</source>
        <translation>la trame est du type %1, pas d ou r</translation>
    </message>
    <message>
        <source>the frame says %1 in the place of Rx or Tx</source>
        <translation>la trame indique %1 à la place de Rx ou Tx</translation>
    </message>
    <message>
        <source>the gain had nothing to act on</source>
        <translation>le gain n’avait rien sur quoi agir</translation>
    </message>
    <message>
        <source>the gain scale is too coarse to be measured with so little power</source>
        <translation>l’échelle du gain est trop grossière pour être mesurée avec si peu de puissance</translation>
    </message>
    <message>
        <source>the gains found at different values do not agree, so that a gain is no simple factor</source>
        <translation>les gains trouvés à différentes valeurs ne concordent pas&#xa0;: un gain n’est donc pas un simple facteur</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop may not move it; write its p, d and divisor once</source>
        <translation>les gains de cette boucle ne sont pas connus ici, sa cible reste donc à moins de %1 de sa position&#xa0;: une boucle faible ne le déplacera peut-être pas&#x202f;; écrivez une fois son p, son d et son divisor</translation>
    </message>
    <message>
        <source>the gains stored in the drive are erased; all its loops do nothing until they are written again</source>
        <translation>les gains mémorisés dans le variateur sont effacés&#x202f;; toutes ses boucles restent sans effet jusqu’à leur réécriture</translation>
    </message>
    <message>
        <source>the gains that trial #%1 had changed are put back</source>
        <translation>les gains modifiés par l’essai n° %1 sont rétablis</translation>
    </message>
    <message>
        <source>the guardian does not answer</source>
        <translation>le gardien ne répond pas</translation>
    </message>
    <message>
        <source>the guardian does not stand by yet</source>
        <translation>le gardien n’est pas encore prêt</translation>
    </message>
    <message>
        <source>the guardian ended unexpectedly</source>
        <translation>le gardien s’est terminé de façon inattendue</translation>
    </message>
    <message>
        <source>the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands</source>
        <translation>le gardien a envoyé l’arrêt, que rien ne confirme sur cette liaison&#x202f;; vérifiez que le moteur est à l’arrêt</translation>
    </message>
    <message>
        <source>the guardian has stopped the motor</source>
        <translation>le gardien a arrêté le moteur</translation>
    </message>
    <message>
        <source>the guardian is of another version</source>
        <translation>le gardien est d’une autre version</translation>
    </message>
    <message>
        <source>the guardian sent the stop because this program was held up, not confirmed</source>
        <translation>le gardien a envoyé l’arrêt parce que ce programme était bloqué, non confirmé</translation>
    </message>
    <message>
        <source>the guardian stopped the motor because this program was held up</source>
        <translation>le gardien a arrêté le moteur parce que ce programme était bloqué</translation>
    </message>
    <message>
        <source>the guardian tried in vain to stop the motor; it may still turn: cut its power</source>
        <translation>le gardien a tenté en vain d’arrêter le moteur&#x202f;; il tourne peut-être encore&#xa0;: coupez son alimentation</translation>
    </message>
    <message>
        <source>the guardian tried to stop the motor because this program was held up, without an answer</source>
        <translation>le gardien a tenté d’arrêter le moteur parce que ce programme était bloqué, sans réponse</translation>
    </message>
    <message>
        <source>the history does not have this write: %1</source>
        <translation>l’historique n’a pas cette écriture&#xa0;: %1</translation>
    </message>
    <message>
        <source>the history has an unexpected length</source>
        <translation>l’historique a une longueur inattendue</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to do again</source>
        <translation>l’historique de %1 n’a rien à refaire</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to undo</source>
        <translation>l’historique de %1 n’a rien à annuler</translation>
    </message>
    <message>
        <source>the identifier</source>
        <translation>l’identifiant</translation>
    </message>
    <message>
        <source>the identifier extension bit</source>
        <translation>le bit d’extension d’identifiant</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1%2%3</source>
        <translation>l’image est pour le produit 602, cet appareil est le produit %1%2%3</translation>
    </message>
    <message>
        <source>the image itself writes the settings pages</source>
        <translation>l’image écrit elle-même les pages de réglages</translation>
    </message>
    <message>
        <source>the intermission</source>
        <translation>l’intermission</translation>
    </message>
    <message>
        <source>the journal on the server was made by a newer version of this program</source>
        <translation>le registre du serveur provient d’une version plus récente de ce programme</translation>
    </message>
    <message>
        <source>the journal&apos;s server: %1</source>
        <translation>le serveur du registre&#xa0;: %1</translation>
    </message>
    <message>
        <source>the jumper is still in: take it out, then reset the board</source>
        <translation>le cavalier est encore en place&#xa0;: retirez-le, puis réinitialisez la carte</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>le noyau n’énumère pas ses interfaces&#xa0;: %1</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is there twice</source>
        <translation>la clé «&#xa0;%1&#xa0;» figure deux fois</translation>
    </message>
    <message>
        <source>the layout has more than 500 traces</source>
        <translation>la disposition a plus de 500 courbes</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>la longueur</translation>
    </message>
    <message>
        <source>the length of the frame is %1</source>
        <translation>la longueur de la trame est %1</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; must be the greatest value, 0 or more, or [least, greatest]</source>
        <translation>la limite de «&#xa0;%1&#xa0;» doit être la valeur maximale, 0 ou plus, ou [minimum, maximum]</translation>
    </message>
    <message>
        <source>the link is not open</source>
        <translation>la liaison n’est pas ouverte</translation>
    </message>
    <message>
        <source>the link was opened anew</source>
        <translation>la liaison a été rouverte</translation>
    </message>
    <message>
        <source>the loop drives the motor the wrong way</source>
        <translation>la boucle entraîne le moteur dans le mauvais sens</translation>
    </message>
    <message>
        <source>the loop swings itself up: %1 swings, each larger than the last or with full duty</source>
        <translation>la boucle se met à osciller&#xa0;: %1 oscillations, chacune plus grande que la précédente ou à plein rapport cyclique</translation>
    </message>
    <message>
        <source>the loop does not come to rest: %1 swings</source>
        <translation>la boucle ne se stabilise pas&#xa0;: %1 oscillations</translation>
    </message>
    <message>
        <source>the loop would be undefined</source>
        <translation>la boucle serait indéfinie</translation>
    </message>
    <message>
        <source>the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)</source>
        <translation>le microcontrôleur du variateur est f1 (STM32F1) ou f4 (STM32F4)</translation>
    </message>
    <message>
        <source>the model is not to be believed: %1</source>
        <translation>le modèle n’est pas crédible&#xa0;: %1</translation>
    </message>
    <message>
        <source>the motor did not follow a step: stalled, or the encoder is dead</source>
        <translation>le moteur n’a pas suivi un échelon&#xa0;: bloqué, ou le codeur est mort</translation>
    </message>
    <message>
        <source>the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead</source>
        <translation>le moteur n’a pas bougé jusqu’à %1 % de rapport cyclique (%2 counts)&#xa0;: bloqué, ou le codeur est mort</translation>
    </message>
    <message>
        <source>the motor did not turn at two of the powers</source>
        <translation>le moteur n’a pas tourné à deux des puissances</translation>
    </message>
    <message>
        <source>the motor did not turn at up to %1 duty: stalled, or the encoder is dead</source>
        <translation>le moteur n’a pas tourné jusqu’à %1 de rapport cyclique&#xa0;: bloqué, ou le codeur est mort</translation>
    </message>
    <message>
        <source>the motor did not turn the way it was pushed</source>
        <translation>le moteur n’a pas tourné dans le sens où il était poussé</translation>
    </message>
    <message>
        <source>the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms</source>
        <translation>le moteur donne %1 counts/s par unité de puissance, le frottement prend %2 unités, il suit en %3 ms</translation>
    </message>
    <message>
        <source>the motor is not seen to stand</source>
        <translation>l’arrêt du moteur n’est pas constaté</translation>
    </message>
    <message>
        <source>the motor ran faster than the power limit allows</source>
        <translation>le moteur a tourné plus vite que la limite de puissance ne le permet</translation>
    </message>
    <message>
        <source>the motor reversed during a sine of %1 Hz: friction is in it</source>
        <translation>le moteur s’est inversé pendant un sinus de %1 Hz&#xa0;: il y a du frottement dedans</translation>
    </message>
    <message>
        <source>the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool</source>
        <translation>le moteur a pris la chaleur de %1 s à %2 A, 10 s sont permises&#x202f;; laissez-le refroidir</translation>
    </message>
    <message>
        <source>the motor turned too short a time below the power limit to be measured</source>
        <translation>le moteur a tourné trop peu de temps sous la limite de puissance pour être mesuré</translation>
    </message>
    <message>
        <source>the motor turns differently in both directions</source>
        <translation>le moteur tourne différemment dans les deux sens</translation>
    </message>
    <message>
        <source>the motor was not seen to stand</source>
        <translation>l’arrêt du moteur n’a pas été constaté</translation>
    </message>
    <message>
        <source>the motor was stopped</source>
        <translation>le moteur a été arrêté</translation>
    </message>
    <message>
        <source>the motor was stopped: %1</source>
        <translation>le moteur a été arrêté&#xa0;: %1</translation>
    </message>
    <message>
        <source>the motors that were not seen to stand were looked at; their stops are dismissed</source>
        <translation>les moteurs dont l’arrêt n’était pas constaté ont été examinés&#x202f;; leurs arrêts sont clos</translation>
    </message>
    <message>
        <source>the motors were told to stop, and are not seen to stand</source>
        <translation>l’ordre d’arrêt a été donné aux moteurs, mais leur arrêt n’est pas constaté</translation>
    </message>
    <message>
        <source>the name was written, but the device answers &apos;%1&apos;</source>
        <translation>le nom a été écrit, mais l’appareil répond «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>the nearest it can is %1</source>
        <translation>au plus près, il peut %1</translation>
    </message>
    <message>
        <source>the offset of an Abstract DC Drive is compiled into its firmware</source>
        <translation>l’offset d’un Abstract DC Drive est compilé dans son firmware</translation>
    </message>
    <message>
        <source>the order was dropped: what it was for has ended</source>
        <translation>l’ordre a été abandonné&#xa0;: ce pour quoi il était fait est terminé</translation>
    </message>
    <message>
        <source>the other end of %1 closed it</source>
        <translation>l’autre extrémité de %1 l’a fermée</translation>
    </message>
    <message>
        <source>the other end of %1 hung up</source>
        <translation>l’autre extrémité de %1 a raccroché</translation>
    </message>
    <message>
        <source>the output of its loop passed 32767, where it turns to full reverse</source>
        <translation>la sortie de sa boucle a dépassé 32767, où elle bascule à fond en arrière</translation>
    </message>
    <message>
        <source>the packet is too long for the board</source>
        <translation>le paquet est trop long pour la carte</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter</source>
        <translation>le plugin %1 ne trouve aucun adaptateur</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter (%2)</source>
        <translation>le plugin %1 ne trouve aucun adaptateur (%2)</translation>
    </message>
    <message>
        <source>the position is not known yet, so nothing would keep the motor from jumping</source>
        <translation>la position n’est pas encore connue, rien n’empêcherait donc le moteur de sauter</translation>
    </message>
    <message>
        <source>the position is written only while the output is off</source>
        <translation>la position ne s’écrit que quand la sortie est coupée</translation>
    </message>
    <message>
        <source>the position was not reset: %1</source>
        <translation>la position n’a pas été remise à zéro&#xa0;: %1</translation>
    </message>
    <message>
        <source>the positions have an unexpected length</source>
        <translation>les positions ont une longueur inattendue</translation>
    </message>
    <message>
        <source>the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity</source>
        <translation>le mouvement avec profil a dépassé sa cible de plus que sa distance d’arrêt, ce que ce firmware peut faire au-dessus de 2500 counts/s&#x202f;; utilisez un profile.velocity plus faible</translation>
    </message>
    <message>
        <source>the pushes differ by %1 in their resistance, at most 15 %</source>
        <translation>les poussées diffèrent de %1 en résistance, au plus 15 %</translation>
    </message>
    <message>
        <source>the ramp must be 0 (immediate) or a positive number of duty per second</source>
        <translation>la rampe doit être 0 (immédiate) ou un rapport cyclique par seconde positif</translation>
    </message>
    <message>
        <source>the ramp must be 0 or a positive number of duty per second</source>
        <translation>la rampe doit être 0 ou un rapport cyclique par seconde positif</translation>
    </message>
    <message>
        <source>the ready line stayed low</source>
        <translation>la ligne prêt est restée à l’état bas</translation>
    </message>
    <message>
        <source>the record is cut off after %1 bytes</source>
        <translation>l’enregistrement est tronqué après %1 octets</translation>
    </message>
    <message>
        <source>the recording has ended: %1</source>
        <translation>l’enregistrement est terminé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the remote bit</source>
        <translation>le bit remote</translation>
    </message>
    <message>
        <source>the reply has an unexpected length</source>
        <translation>la réponse a une longueur inattendue</translation>
    </message>
    <message>
        <source>the report cannot be painted</source>
        <translation>le rapport ne peut pas être dessiné</translation>
    </message>
    <message>
        <source>the reset line was pulsed</source>
        <translation>une impulsion a été envoyée sur la ligne de reset</translation>
    </message>
    <message>
        <source>the resistance is known within %1, at most 10 %</source>
        <translation>la résistance est connue à %1 près, au plus 10 %</translation>
    </message>
    <message>
        <source>the response could not be measured</source>
        <translation>la réponse n’a pas pu être mesurée</translation>
    </message>
    <message>
        <source>the same interface as socketcan:%1, which also counts losses</source>
        <translation>la même interface que socketcan:%1, qui compte aussi les pertes</translation>
    </message>
    <message>
        <source>the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its power at most</source>
        <translation>l’échelle de ses gains n’est pas encore connue et est cherchée d’abord&#xa0;: une à deux minutes, avec %1 % de sa puissance au plus</translation>
    </message>
    <message>
        <source>the search was cancelled; what it found stays</source>
        <translation>la recherche a été annulée&#x202f;; ce qu’elle a trouvé reste</translation>
    </message>
    <message>
        <source>the self-test could not go on: %1</source>
        <translation>l’autotest n’a pas pu continuer&#xa0;: %1</translation>
    </message>
    <message>
        <source>the self-test was ended by the guard &apos;%1&apos;: %2</source>
        <translation>l’autotest a été interrompu par la surveillance «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>the self-test was stopped by hand</source>
        <translation>l’autotest a été arrêté à la main</translation>
    </message>
    <message>
        <source>the sensor counts down when the motor is driven up (%1 counts): one of them is reversed</source>
        <translation>le capteur compte vers le bas quand le moteur est entraîné vers le haut (%1 counts)&#xa0;: l’un des deux est inversé</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts down</source>
        <translation>le capteur est inversé&#xa0;: il compte vers le bas</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts up</source>
        <translation>le capteur est inversé&#xa0;: il compte vers le haut</translation>
    </message>
    <message>
        <source>the set-point comes from here, not from the device</source>
        <translation>la consigne vient d’ici, pas de l’appareil</translation>
    </message>
    <message>
        <source>the set-point of the step</source>
        <translation>la consigne de l’échelon</translation>
    </message>
    <message>
        <source>the settings of the %1 loop were saved %2 times</source>
        <translation>les réglages de la boucle %1 ont été mémorisés %2 fois</translation>
    </message>
    <message>
        <source>the settings that the reset took are written again</source>
        <translation>les réglages perdus par la réinitialisation sont réécrits</translation>
    </message>
    <message>
        <source>the shaft must be free, without load on one side</source>
        <translation>l’arbre doit être libre, sans charge d’un côté</translation>
    </message>
    <message>
        <source>the simulated board is in use by another link</source>
        <translation>la carte simulée est utilisée par une autre liaison</translation>
    </message>
    <message>
        <source>the simulator at %1 closed the connection</source>
        <translation>le simulateur à %1 a fermé la connexion</translation>
    </message>
    <message>
        <source>the simulator at %1 sent bytes that nobody asked for</source>
        <translation>le simulateur à %1 a envoyé des octets que personne n’a demandés</translation>
    </message>
    <message>
        <source>the speed does not grow evenly with the power</source>
        <translation>la vitesse ne croît pas régulièrement avec la puissance</translation>
    </message>
    <message>
        <source>the start of frame</source>
        <translation>le début de trame</translation>
    </message>
    <message>
        <source>the status bit is the same with both polarities, so it tells nothing</source>
        <translation>le bit d’état est le même avec les deux polarités, il n’indique donc rien</translation>
    </message>
    <message>
        <source>the steps met the end of the output</source>
        <translation>les échelons ont atteint la butée de la sortie</translation>
    </message>
    <message>
        <source>the stop before it is not acknowledged yet</source>
        <translation>l’arrêt précédent n’est pas encore acquitté</translation>
    </message>
    <message>
        <source>the stop could not be sent, and is the first thing that goes out when the line is back; cut its power</source>
        <translation>l’arrêt n’a pas pu être envoyé, et partira en premier quand la ligne sera rétablie&#x202f;; coupez l’alimentation</translation>
    </message>
    <message>
        <source>the stop of the self-test was not confirmed: %1</source>
        <translation>l’arrêt de l’autotest n’a pas été confirmé&#xa0;: %1</translation>
    </message>
    <message>
        <source>the stop script of this device is not one that a guardian can carry out</source>
        <translation>le script d’arrêt de cet appareil ne peut pas être exécuté par un gardien</translation>
    </message>
    <message>
        <source>the stop was not acknowledged, so the position was not reset: a motor that runs would jump</source>
        <translation>l’arrêt n’a pas été acquitté, donc la position n’a pas été remise à zéro&#xa0;: un moteur en marche sauterait</translation>
    </message>
    <message>
        <source>the stream settings have an unexpected length</source>
        <translation>les réglages du flux ont une longueur inattendue</translation>
    </message>
    <message>
        <source>the substitute remote bit</source>
        <translation>le bit remote de substitution</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>la cible</translation>
    </message>
    <message>
        <source>the text is longer than %1 MiB</source>
        <translation>le texte dépasse %1 MiB</translation>
    </message>
    <message>
        <source>the time stamp %1 is out of range</source>
        <translation>l’horodatage %1 est hors plage</translation>
    </message>
    <message>
        <source>the time stamps are %1, not absolute or relative</source>
        <translation>les horodatages sont %1, pas absolute ou relative</translation>
    </message>
    <message>
        <source>the transceiver reports an error</source>
        <translation>le transceiver signale une erreur</translation>
    </message>
    <message>
        <source>the transcript of the update is in %1</source>
        <translation>la transcription de la mise à jour est dans %1</translation>
    </message>
    <message>
        <source>the transcript of the update is not kept: %1</source>
        <translation>la transcription de la mise à jour n’est pas conservée&#xa0;: %1</translation>
    </message>
    <message>
        <source>the tuning is not in the notebook: %1</source>
        <translation>le réglage n’est pas dans le carnet&#xa0;: %1</translation>
    </message>
    <message>
        <source>the two directions differ by %1, at most 10 %</source>
        <translation>les deux sens diffèrent de %1, au plus 10 %</translation>
    </message>
    <message>
        <source>the unit answers with firmware %1, the image is %2</source>
        <translation>l’appareil répond avec le firmware %1, l’image est %2</translation>
    </message>
    <message>
        <source>the unit does not answer an enumeration</source>
        <translation>l’appareil ne répond pas à une énumération</translation>
    </message>
    <message>
        <source>the unit may have restarted meanwhile: once more from page %1</source>
        <translation>l’appareil a peut-être redémarré entre-temps&#xa0;: reprise à partir de la page %1</translation>
    </message>
    <message>
        <source>the unit restarted: what is volatile was lost, its parameters are read again</source>
        <translation>l’appareil a redémarré&#xa0;: les données volatiles sont perdues, ses paramètres sont relus</translation>
    </message>
    <message>
        <source>the unit said it is in its bootloader, but its application answers</source>
        <translation>l’appareil a dit être dans son bootloader, mais son application répond</translation>
    </message>
    <message>
        <source>the unit stays %1 away from where the experiment begins, more than 2 % of its step</source>
        <translation>l’appareil reste à %1 du départ de l’expérience, plus de 2 % de son échelon</translation>
    </message>
    <message>
        <source>the unit stores no P, so nothing moves it</source>
        <translation>l’appareil ne mémorise pas de P, donc rien ne le fait bouger</translation>
    </message>
    <message>
        <source>the unit stores them by itself within %1 s</source>
        <translation>l’appareil les mémorise de lui-même en %1 s</translation>
    </message>
    <message>
        <source>the unit tells no duty, no current or no position, so its resistance is not known</source>
        <translation>l’appareil n’indique pas le rapport cyclique, le courant ou la position, sa résistance n’est donc pas connue</translation>
    </message>
    <message>
        <source>the unit waits in its bootloader, run the update again</source>
        <translation>l’appareil attend dans son bootloader, relancez la mise à jour</translation>
    </message>
    <message>
        <source>the unit was not heard during the self-test: %1</source>
        <translation>l’appareil ne s’est pas fait entendre pendant l’autotest&#xa0;: %1</translation>
    </message>
    <message>
        <source>the user stopped it</source>
        <translation>l’utilisateur l’a arrêté</translation>
    </message>
    <message>
        <source>the user-ID words</source>
        <translation>les mots user-ID</translation>
    </message>
    <message>
        <source>the values are not put back: %1</source>
        <translation>les valeurs ne sont pas rétablies&#xa0;: %1</translation>
    </message>
    <message>
        <source>the values are put back</source>
        <translation>les valeurs sont rétablies</translation>
    </message>
    <message>
        <source>the values stay with this program and are written again after a reset</source>
        <translation>les valeurs restent dans ce programme et sont réécrites après une réinitialisation</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0x0000</source>
        <translation>la version à 0x1EFFC est 0x0000</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0xFFFF, which means no application</source>
        <translation>la version à 0x1EFFC est 0xFFFF, c’est-à-dire aucune application</translation>
    </message>
    <message>
        <source>the version has an unexpected length</source>
        <translation>la version a une longueur inattendue</translation>
    </message>
    <message>
        <source>the window of the layout is out of range</source>
        <translation>la fenêtre de la disposition est hors plage</translation>
    </message>
    <message>
        <source>the wire lost too many frames; the same again</source>
        <translation>la ligne a perdu trop de trames&#x202f;; la même chose encore une fois</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>il n’y a pas de %1</translation>
    </message>
    <message>
        <source>there is no CAN interface</source>
        <translation>il n’y a pas d’interface CAN</translation>
    </message>
    <message>
        <source>there is no CAN interface %1</source>
        <translation>il n’y a pas d’interface CAN %1</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1</source>
        <translation>il n’y a pas de plugin CAN %1</translation>
    </message>
    <message>
        <source>there is no GPIO chip for %1</source>
        <translation>il n’y a pas de puce GPIO pour %1</translation>
    </message>
    <message>
        <source>there is no entry %1 in the journal</source>
        <translation>il n’y a pas d’entrée %1 dans le registre</translation>
    </message>
    <message>
        <source>there is no file &apos;%1&apos;</source>
        <translation>il n’y a pas de fichier «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>there is no layout of this name</source>
        <translation>il n’y a pas de disposition de ce nom</translation>
    </message>
    <message>
        <source>there is no simulated link &apos;sim:%1&apos;: can, serial and spi are known</source>
        <translation>il n’y a pas de liaison simulée «&#xa0;sim:%1&#xa0;»&#x202f;; connues&#xa0;: can, serial et spi</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos;</source>
        <translation>il n’y a pas d’instantané «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos; of this unit</source>
        <translation>il n’y a pas d’instantané «&#xa0;%1&#xa0;» de cet appareil</translation>
    </message>
    <message>
        <source>there is no socket %1</source>
        <translation>il n’y a pas de socket %1</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>ce dossier n’existe pas</translation>
    </message>
    <message>
        <source>there is no table here: expected time_s,name (unit),… or t,channel,value,unit</source>
        <translation>il n’y a pas de tableau ici&#xa0;: attendu time_s,name (unit),… ou t,channel,value,unit</translation>
    </message>
    <message>
        <source>there is no trial %1</source>
        <translation>il n’y a pas d’essai %1</translation>
    </message>
    <message>
        <source>there is no way from %1 to itself</source>
        <translation>il n’y a pas de chemin de %1 à lui-même</translation>
    </message>
    <message>
        <source>there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s</source>
        <translation>il n’y a pas assez de place pour une réponse fréquentielle&#xa0;: ses limites laissent une vitesse de %1 counts/s pendant %2 s</translation>
    </message>
    <message>
        <source>there is not enough room to identify the motor: its limits leave pushes of %1 duty only</source>
        <translation>il n’y a pas assez de place pour identifier le moteur&#xa0;: ses limites ne laissent que des poussées à %1 de rapport cyclique</translation>
    </message>
    <message>
        <source>there is not enough room: its limits leave steps of %1 counts</source>
        <translation>il n’y a pas assez de place&#xa0;: ses limites laissent des échelons de %1 counts</translation>
    </message>
    <message>
        <source>these are the calm gains, %1</source>
        <translation>ce sont les gains calmes, %1</translation>
    </message>
    <message>
        <source>they have speed and interface</source>
        <translation>connus&#xa0;: speed et interface</translation>
    </message>
    <message>
        <source>this build knows %1</source>
        <translation>cette version connaît %1</translation>
    </message>
    <message>
        <source>this build simulates no devices on sim:%1</source>
        <translation>cette version ne simule aucun appareil sur sim:%1</translation>
    </message>
    <message>
        <source>this change waits for nobody</source>
        <translation>cette modification n’attend personne</translation>
    </message>
    <message>
        <source>this command is not known to firmware of dialect %1</source>
        <translation>cette commande n’est pas connue du firmware de dialecte %1</translation>
    </message>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>cet ordinateur n’a pas de pilote pour PostgreSQL</translation>
    </message>
    <message>
        <source>this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile</source>
        <translation>cet ordinateur n’est pas maintenu éveillé pendant le pilotage de moteurs ou l’écriture de firmware&#xa0;: %1&#x202f;; désactivez entre-temps sa mise en veille automatique</translation>
    </message>
    <message>
        <source>this device has no experiment &apos;%1&apos;</source>
        <translation>cet appareil n’a pas d’expérience «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>this device has no watchdog, and nothing here would stop it if the program died</source>
        <translation>cet appareil n’a pas de chien de garde, et rien ici ne l’arrêterait si le programme plantait</translation>
    </message>
    <message>
        <source>this device has no watchdog, and on %1 nothing could stop it if the program died</source>
        <translation>cet appareil n’a pas de chien de garde, et sur %1 rien ne pourrait l’arrêter si le programme plantait</translation>
    </message>
    <message>
        <source>this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then</source>
        <translation>ce firmware peut dépasser la cible d’un mouvement avec profil au-dessus de 2500 counts/s&#x202f;; il est alors arrêté</translation>
    </message>
    <message>
        <source>this image holds a bootloader too, which cannot write itself</source>
        <translation>cette image contient aussi un bootloader, qui ne peut pas s’écrire lui-même</translation>
    </message>
    <message>
        <source>this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s</source>
        <translation>cette interface ne peut pas écouter sans perturber le bus, demandez donc à qui l’a installé&#x202f;; usuels&#xa0;: 1 Mbit/s, 500, 250 et 125 kbit/s</translation>
    </message>
    <message>
        <source>this is another unit by now, number %1</source>
        <translation>c’est entre-temps un autre appareil, numéro %1</translation>
    </message>
    <message>
        <source>this is no layout of plots</source>
        <translation>ce n’est pas une disposition de courbes</translation>
    </message>
    <message>
        <source>this is no program for the controller: it does not begin with a jump of an AVR at address 0</source>
        <translation>ce n’est pas un programme pour le contrôleur&#xa0;: il ne commence pas par un saut d’AVR à l’adresse 0</translation>
    </message>
    <message>
        <source>this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P</source>
        <translation>ce n’est pas un programme pour le contrôleur&#xa0;: il a des octets hors des 32 KiB d’un ATmega328P</translation>
    </message>
    <message>
        <source>this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … 0x081FFFFF</source>
        <translation>ce n’est pas un programme pour le variateur&#xa0;: il a des octets hors de la flash d’un STM32, 0x08000000 … 0x081FFFFF</translation>
    </message>
    <message>
        <source>this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</source>
        <translation>ce n’est pas un programme pour le variateur&#xa0;: aucun vecteur d’un STM32 à 0x08000000. Créez le fichier Intel HEX avec&#xa0;: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</translation>
    </message>
    <message>
        <source>this is no recipe of version 1</source>
        <translation>ce n’est pas une recette de version 1</translation>
    </message>
    <message>
        <source>this is no session of MotorBench</source>
        <translation>ce n’est pas une session MotorBench</translation>
    </message>
    <message>
        <source>this kernel has no CAN support</source>
        <translation>ce noyau ne prend pas en charge CAN</translation>
    </message>
    <message>
        <source>this program was held up for %1 ms, longer than the motor goes without a set-point</source>
        <translation>ce programme a été bloqué %1 ms, plus longtemps que le moteur ne se passe de consigne</translation>
    </message>
    <message>
        <source>this program was held up for so long that the guardian may have stopped the motor</source>
        <translation>ce programme a été bloqué si longtemps que le gardien a peut-être arrêté le moteur</translation>
    </message>
    <message>
        <source>this takes too long</source>
        <translation>cela prend trop de temps</translation>
    </message>
    <message>
        <source>this trial has no sine and no positions</source>
        <translation>cet essai n’a ni sinus ni positions</translation>
    </message>
    <message>
        <source>this trial is kept without its result: %1</source>
        <translation>cet essai est conservé sans son résultat&#xa0;: %1</translation>
    </message>
    <message>
        <source>this trial is not kept: %1</source>
        <translation>cet essai n’est pas conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>this trial owes nothing to the unit</source>
        <translation>cet essai ne doit rien à l’appareil</translation>
    </message>
    <message>
        <source>this unit has no number yet</source>
        <translation>cet appareil n’a pas encore de numéro</translation>
    </message>
    <message>
        <source>this unit has no number yet, and without one its motor may not be driven</source>
        <translation>cet appareil n’a pas encore de numéro, et sans numéro son moteur ne doit pas être piloté</translation>
    </message>
    <message>
        <source>this unit waits in its bootloader, and the recipe has no firmware for it</source>
        <translation>cet appareil attend dans son bootloader, et la recette n’a pas de firmware pour lui</translation>
    </message>
    <message>
        <source>to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9</source>
        <translation>fiable jusqu’à %1 Hz, tant que dix échantillons par oscillation et une cohérence de 0,9 le permettent</translation>
    </message>
    <message>
        <source>too few samples for a sine of %1 Hz</source>
        <translation>trop peu d’échantillons pour un sinus de %1 Hz</translation>
    </message>
    <message>
        <source>too few steps to tell what the gains of this loop do</source>
        <translation>trop peu d’échelons pour dire ce que font les gains de cette boucle</translation>
    </message>
    <message>
        <source>transmission timed out</source>
        <translation>délai d’émission dépassé</translation>
    </message>
    <message>
        <source>trial #%1</source>
        <translation>essai n° %1</translation>
    </message>
    <message>
        <source>try a lower speed=</source>
        <translation>essayez un speed= plus faible</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>réessayez</translation>
    </message>
    <message>
        <source>try its position loop</source>
        <translation>essayez sa boucle de position</translation>
    </message>
    <message>
        <source>tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>réglez-le à la main avec «&#xa0;motorbenchctl step&#xa0;»</translation>
    </message>
    <message>
        <source>tuning %1: %2</source>
        <translation>réglage %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>turning the motor with several powers</source>
        <translation>rotation du moteur à plusieurs puissances</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>units are served already</source>
        <translation>des appareils sont déjà en cours de traitement</translation>
    </message>
    <message>
        <source>units are served on this link</source>
        <translation>des appareils sont en cours de traitement sur cette liaison</translation>
    </message>
    <message>
        <source>unix links have no option &apos;%1&apos;</source>
        <translation>les liaisons unix n’ont pas d’option «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>erreur inconnue</translation>
    </message>
    <message>
        <source>unknown family &apos;%1&apos;</source>
        <translation>famille inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown fault &apos;%1&apos;</source>
        <translation>défaut inconnu «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>clé inconnue %1</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>clé inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown link kind &apos;%1&apos;: sim, socketcan, qtcan, serial, spidev, unix and replay are known</source>
        <translation>type de liaison inconnu «&#xa0;%1&#xa0;»&#x202f;; connus&#xa0;: sim, socketcan, qtcan, serial, spidev, unix et replay</translation>
    </message>
    <message>
        <source>unknown loop &apos;%1&apos;</source>
        <translation>boucle inconnue «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a serial link</source>
        <translation>option inconnue «&#xa0;%1&#xa0;» d’une liaison série</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a simulated link</source>
        <translation>option inconnue «&#xa0;%1&#xa0;» d’une liaison simulée</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>débranchez-le et rebranchez-le</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>illisible</translation>
    </message>
    <message>
        <source>update its firmware first</source>
        <translation>mettez d’abord à jour son firmware</translation>
    </message>
    <message>
        <source>use a programmer on the pins</source>
        <translation>utilisez un programmateur sur les broches</translation>
    </message>
    <message>
        <source>use an interface of the kernel</source>
        <translation>utilisez une interface du noyau</translation>
    </message>
    <message>
        <source>use that one</source>
        <translation>utilisez celui-là</translation>
    </message>
    <message>
        <source>velocity is −100000 to 100000 counts/s</source>
        <translation>la vitesse va de −100000 à 100000 counts/s</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>virtuel</translation>
    </message>
    <message>
        <source>wait until it is heard</source>
        <translation>attendez qu’il se fasse entendre</translation>
    </message>
    <message>
        <source>was not seen to stop: the motor may still turn, cut its power</source>
        <translation>arrêt non constaté&#xa0;: le moteur tourne peut-être encore, coupez son alimentation</translation>
    </message>
    <message>
        <source>was seen to stand</source>
        <translation>arrêt constaté</translation>
    </message>
    <message>
        <source>what D does is known within %1, at most 30 %</source>
        <translation>ce que fait D est connu à %1 près, au plus 30 %</translation>
    </message>
    <message>
        <source>what a gain of %1 means in this loop is not known</source>
        <translation>la signification d’un gain de %1 dans cette boucle n’est pas connue</translation>
    </message>
    <message>
        <source>what a raw gain of this board puts out is not known (%1)</source>
        <translation>ce que produit un gain brut de cette carte n’est pas connu (%1)</translation>
    </message>
    <message>
        <source>what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost with the restart</source>
        <translation>ce qu’un autre programme a modifié dans les 15 dernières s n’est pas encore dans la flash de l’appareil, et se perd au redémarrage</translation>
    </message>
    <message>
        <source>what is left over is %1 of the steps, at most 8 %</source>
        <translation>il reste %1 des échelons, au plus 8 %</translation>
    </message>
    <message>
        <source>what is missing is still unknown, do it again</source>
        <translation>ce qui manque est toujours inconnu, recommencez</translation>
    </message>
    <message>
        <source>what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it</source>
        <translation>ce qui est envoyé au nœud %1 est aussi exécuté par le nœud %2, maintenant ou après un redémarrage, à cause d’un masque d’acceptation&#x202f;; mettez son node.mask à 255 et redémarrez-le</translation>
    </message>
    <message>
        <source>what the gains of this loop make is not known any more</source>
        <translation>l’effet des gains de cette boucle n’est plus connu</translation>
    </message>
    <message>
        <source>where it is neither, its gain.p is too small for so short a way</source>
        <translation>s’il n’est ni l’un ni l’autre, son gain.p est trop petit pour une distance si courte</translation>
    </message>
    <message>
        <source>without a ready line the board is asked 100 times a second, and cannot stream</source>
        <translation>sans ligne prêt, la carte est interrogée 100 fois par seconde et ne peut pas émettre de flux</translation>
    </message>
    <message>
        <source>without it nothing would stop this motor if the program died: install it there</source>
        <translation>sans lui, rien n’arrêterait ce moteur si le programme mourait&#xa0;: installez-le là</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>écrivez %1</translation>
    </message>
    <message>
        <source>write == to compare</source>
        <translation>écrivez == pour comparer</translation>
    </message>
    <message>
        <source>write a larger gain.d once, with which it still comes to rest</source>
        <translation>écrivez une fois un gain.d plus grand, avec lequel il se stabilise encore</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>écrivez un nombre</translation>
    </message>
    <message>
        <source>write a small gain.p once, with which it moves</source>
        <translation>écrivez une fois un petit gain.p, avec lequel il bouge</translation>
    </message>
    <message>
        <source>write a smaller gain.p once</source>
        <translation>écrivez une fois un gain.p plus petit</translation>
    </message>
    <message>
        <source>write it like 2.5</source>
        <translation>écrivez-le comme 2.5</translation>
    </message>
    <message>
        <source>write it with &apos;motorbenchctl set&apos;</source>
        <translation>écrivez-le avec «&#xa0;motorbenchctl set&#xa0;»</translation>
    </message>
    <message>
        <source>write it with a dot, like 1.5, and no comma</source>
        <translation>écrivez-le avec un point, comme 1.5, et sans virgule</translation>
    </message>
    <message>
        <source>write on or off</source>
        <translation>écrivez on ou off</translation>
    </message>
    <message>
        <source>write openocd:INTERFACE, such as openocd:stlink</source>
        <translation>écrivez openocd:INTERFACE, par exemple openocd:stlink</translation>
    </message>
    <message>
        <source>write the gains of this loop once, or keep what is tried</source>
        <translation>écrivez une fois les gains de cette boucle, ou gardez ce qui est essayé</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>écrivez true ou false</translation>
    </message>
    <message>
        <source>written again: %1</source>
        <translation>réécrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>written, but the current limit, which this firmware overwrites with it, could not be put back to %1 mA: %2</source>
        <translation>écrit, mais la limite de courant, que ce firmware écrase ainsi, n’a pas pu être remise à %1 mA&#xa0;: %2</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>vif</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>calme</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservé</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>proposé</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>rolled-back</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots by %3</source>
        <translation>P seul, dans une boucle qui regarde le courant toutes les %1, tient %2 de ce qui est demandé quand il dépasse de %3</translation>
    </message>
    <message>
        <source>allow more travel, so that pushes may last</source>
        <translation>autorisez plus de course, pour que les poussées puissent durer</translation>
    </message>
    <message>
        <source>drive it by duty, or try its I with &apos;motorbenchctl step&apos;: not every build of the firmware runs it</source>
        <translation>pilotez-le par rapport cyclique, ou essayez son I avec «&#xa0;motorbenchctl step&#xa0;»&#xa0;: toutes les versions du firmware ne le calculent pas</translation>
    </message>
    <message>
        <source>friction takes %1 duty, and %2 may push: too little for a motor to swing</source>
        <translation>le frottement prend %1 de rapport cyclique, et %2 peuvent pousser&#xa0;: trop peu pour qu’un moteur oscille</translation>
    </message>
    <message>
        <source>its current stays %1 A behind while the motor speeds up</source>
        <translation>son courant reste %1 A en arrière tant que le moteur accélère</translation>
    </message>
    <message>
        <source>no motor of this gain swings by %1 counts every %2</source>
        <translation>aucun moteur de ce gain n’oscille de %1 counts toutes les %2</translation>
    </message>
    <message>
        <source>now those of the model as that step has corrected it</source>
        <translation>maintenant ceux du modèle tel que cet échelon l’a corrigé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>swinging with %1 duty to and fro</source>
        <translation>oscillation à %1 de rapport cyclique, dans un sens puis dans l’autre</translation>
    </message>
    <message>
        <source>the %1 gains of the first model did not: %2</source>
        <translation>les gains «&#xa0;%1&#xa0;» du premier modèle ne l’ont pas fait&#xa0;: %2</translation>
    </message>
    <message>
        <source>the gain is known within %1, at most 15 %</source>
        <translation>le gain est connu à %1 près, au plus 15 %</translation>
    </message>
    <message>
        <source>the motor did not swing evenly under a duty that changes its sign</source>
        <translation>le moteur n’a pas oscillé régulièrement sous un rapport cyclique qui change de signe</translation>
    </message>
    <message>
        <source>their model was corrected by a step, %1</source>
        <translation>leur modèle a été corrigé par un échelon, %1</translation>
    </message>
    <message>
        <source>there is no room for pushes that last</source>
        <translation>il n’y a pas de place pour des poussées qui durent</translation>
    </message>
    <message>
        <source>there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods differ by %4, at most 10 %</source>
        <translation>il n’y avait pas de place pour de longues poussées&#xa0;; à %1 de rapport cyclique dans un sens puis dans l’autre, il oscille de %2 counts toutes les %3, les périodes diffèrent de %4, au plus 10 %</translation>
    </message>
    <message>
        <source>this unit is for motors of more current</source>
        <translation>cet appareil est fait pour des moteurs de plus de courant</translation>
    </message>
    <message>
        <source>%1 %2 is unusual: %3 units have %4 to %5</source>
        <translation>%1 %2 est inhabituel : %3 unités ont de %4 à %5</translation>
    </message>
    <message>
        <source>%1 besides those of the recipe differ from the backup</source>
        <translation>%1 en dehors de ceux de la recette diffèrent de la sauvegarde</translation>
    </message>
    <message>
        <source>%1 of %2 written</source>
        <translation>%1 sur %2 écrits</translation>
    </message>
    <message>
        <source>%1 pages, %2 sent again</source>
        <translation>%1 pages, %2 renvoyées</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>%1 réglages</translation>
    </message>
    <message>
        <source>1 setting</source>
        <translation>1 réglage</translation>
    </message>
    <message>
        <source>all numbers are used up, the highest is %1</source>
        <translation>tous les numéros sont attribués, le plus élevé est %1</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>déjà %1</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>sauvegarde</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>firmware %1</translation>
    </message>
    <message>
        <source>its flash has it</source>
        <translation>sa flash l&apos;a</translation>
    </message>
    <message>
        <source>no version is told</source>
        <translation>aucune version n&apos;est indiquée</translation>
    </message>
    <message>
        <source>not kept: there is no notebook</source>
        <translation>non conservé : il n&apos;y a pas de carnet</translation>
    </message>
    <message>
        <source>nothing can be read in the bootloader</source>
        <translation>rien ne peut être lu dans le chargeur d&apos;amorçage</translation>
    </message>
    <message>
        <source>nothing had to be stored</source>
        <translation>rien n’était à mémoriser</translation>
    </message>
    <message>
        <source>number</source>
        <translation>numéro</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>numéro %1</translation>
    </message>
    <message>
        <source>number %1, as before</source>
        <translation>numéro %1, comme avant</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>paramètres</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>preflight</source>
        <translation>contrôle préalable</translation>
    </message>
    <message>
        <source>proof</source>
        <translation>vérification</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>relu</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>autotest</translation>
    </message>
    <message>
        <source>snapshot %1 has %2 values</source>
        <translation>l&apos;instantané %1 a %2 valeurs</translation>
    </message>
    <message>
        <source>within its limits</source>
        <translation>dans ses limites</translation>
    </message>
    <message>
        <source>%1 is for no unit that is here and takes firmware over its own link</source>
        <translation>%1 n’est pour aucun appareil présent qui reçoit son firmware par sa propre liaison</translation>
    </message>
    <message>
        <source>%1 is not open, or something runs there</source>
        <translation>%1 n’est pas ouverte, ou quelque chose y tourne</translation>
    </message>
    <message>
        <source>for the others write a recipe that names the way in</source>
        <translation>pour les autres, écrivez une recette qui nomme le chemin</translation>
    </message>
    <message>
        <source>open it, or end what runs there first</source>
        <translation>ouvrez-la, ou terminez d’abord ce qui y tourne</translation>
    </message>
    <message>
        <source>this unit was never served, so there is nothing for a label</source>
        <translation>cet appareil n’a jamais été traité, il n’y a rien pour une étiquette</translation>
    </message>
    <message>
        <source>units are served here; the link stays open</source>
        <translation>des appareils sont traités ici&#xa0;; la liaison reste ouverte</translation>
    </message>
    <message>
        <source>write a page</source>
        <translation>écrivez une page</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>ne répond pas</translation>
    </message>
    <message>
        <source>hold Arm, then put it on again</source>
        <translation>maintenir Armer, puis rebrancher l’appareil</translation>
    </message>
    <message>
        <source>it was cut off at &apos;%1&apos; and does not answer any more</source>
        <translation>il a été interrompu à « %1 » et ne répond plus</translation>
    </message>
    <message>
        <source>left before the station was armed</source>
        <translation>quitté avant que le poste soit armé</translation>
    </message>
    <message>
        <source>look at cable and supply; when it answers again it is served from the beginning</source>
        <translation>vérifier le câble et l’alimentation ; dès qu’il répond, il est traité depuis le début</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for the station to be armed</source>
        <translation>l’appareil a été débranché pendant qu’il attendait l’armement du poste</translation>
    </message>
    <message>
        <source>waits until the station is armed</source>
        <translation>attend que le poste soit armé</translation>
    </message>
    <message>
        <source>a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it</source>
        <translation>un échelon de %1 se trouve dans un bruit de %2, au plus %3 ; la moyenne de %4 le montre</translation>
    </message>
    <message>
        <source>on the model as these steps have corrected it, other gains leave less error; now those</source>
        <translation>sur le modèle tel que ces échelons l&apos;ont corrigé, d&apos;autres gains laissent moins d&apos;erreur ; maintenant ceux-ci</translation>
    </message>
    <message>
        <source>those that were proven first left more error, these leave %1 of it</source>
        <translation>ceux qui ont été éprouvés d&apos;abord laissaient plus d&apos;erreur, ceux-ci en laissent %1</translation>
    </message>
    <message>
        <source>their model was corrected by those that were proven first, which left no clearly more error</source>
        <translation>leur modèle a été corrigé par ceux qui ont été éprouvés d&apos;abord, qui ne laissaient pas nettement plus d&apos;erreur</translation>
    </message>
    <message>
        <source>a chunk of it is damaged</source>
        <translation>un de ses blocs est endommagé</translation>
    </message>
    <message>
        <source>a chunk of it is larger than %1 MB</source>
        <translation>un de ses blocs dépasse %1 Mo</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;; zstd and lz4 are known</source>
        <translation>ses blocs sont compressés par &apos;%1&apos; ; zstd et lz4 sont connus</translation>
    </message>
    <message>
        <source>messages in JSON can be read, and what this program wrote</source>
        <translation>sont lisibles les messages en JSON et ce que ce programme a écrit</translation>
    </message>
    <message>
        <source>--theme takes dark, light, contrast or system</source>
        <translation>--theme accepte dark, light, contrast ou system</translation>
    </message>
    <message>
        <source>give an .mcap with messages in JSON or of this program, a .csv, or the output of watch</source>
        <translation>donnez un .mcap à messages JSON ou de ce programme, un .csv, ou la sortie de watch</translation>
    </message>
    <message>
        <source>overshoot %1, not settled</source>
        <translation>dépassement %1, pas stabilisé</translation>
    </message>
    <message>
        <source>overshoot %1, settled in %2</source>
        <translation>dépassement %1, stabilisé en %2</translation>
    </message>
    <message>
        <source>seed, loss, bitrate and fault are known</source>
        <translation>connus&#xa0;: seed, loss, bitrate et fault</translation>
    </message>
    <message>
        <source>within its limits, at attempt %1: samples were lost before</source>
        <translation>dans ses limites, à l’essai %1&#xa0;: des échantillons avaient été perdus avant</translation>
    </message>
    <message>
        <source>its speed goes on swinging by %1 where it should rest, whole counts alone would make %2</source>
        <translation>sa vitesse continue d’osciller de %1 alors qu’elle devrait se stabiliser, les points entiers seuls donneraient %2</translation>
    </message>
    <message>
        <source>a count or their largest error makes more output than it may</source>
        <translation>un incrément ou leur plus grande erreur produit plus de sortie que permis</translation>
    </message>
    <message>
        <source>the gains that were there may leave as little error; now those</source>
        <translation>les gains qui étaient là laissent peut-être aussi peu d&apos;erreur&#x202f;; maintenant ceux-ci</translation>
    </message>
    <message>
        <source>their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay</source>
        <translation>leur plus grande sensibilité est %1, au plus %2 est permis, et %3 avec plus de gain et de retard</translation>
    </message>
    <message>
        <source>there was no time to compare them with those that were there</source>
        <translation>le temps a manqué pour les comparer à ceux qui étaient là</translation>
    </message>
    <message>
        <source>they would draw more current than is allowed</source>
        <translation>ils consommeraient plus de courant que permis</translation>
    </message>
    <message>
        <source>they would overshoot by %1</source>
        <translation>ils dépasseraient de %1</translation>
    </message>
    <message>
        <source>those that were found left more error: these, which were there, leave %1 of it</source>
        <translation>ceux qui ont été trouvés laissaient plus d&apos;erreur&#xa0;: ceux-ci, qui étaient là, en laissent %1</translation>
    </message>
    <message>
        <source>those that were there leave more error</source>
        <translation>ceux qui étaient là laissent plus d&apos;erreur</translation>
    </message>
    <message>
        <source>those that were there would leave less error, but are not for keeping: %1</source>
        <translation>ceux qui étaient là laisseraient moins d&apos;erreur, mais ne sont pas à garder&#xa0;: %1</translation>
    </message>
    <message>
        <source>what is left over is much of so small steps; the same with larger ones</source>
        <translation>ce qui reste est beaucoup pour de si petits échelons&#x202f;; la même chose avec de plus grands</translation>
    </message>
    <message>
        <source>what was there is not known, and these were not compared with it</source>
        <translation>ce qui était là n&apos;est pas connu, et ceux-ci n&apos;y ont pas été comparés</translation>
    </message>
    <message>
        <source>bus voltage</source>
        <translation>tension du bus</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>sens</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>énergie</translation>
    </message>
    <message>
        <source>foreign master</source>
        <translation>autre maître</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrompu</translation>
    </message>
    <message>
        <source>lateness</source>
        <translation>retard</translation>
    </message>
    <message>
        <source>link</source>
        <translation>liaison</translation>
    </message>
    <message>
        <source>missing guardian</source>
        <translation>gardien absent</translation>
    </message>
    <message>
        <source>no motion</source>
        <translation>pas de mouvement</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>oscillation</translation>
    </message>
    <message>
        <source>refusal</source>
        <translation>refus</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>redémarrage</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>veille</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>température</translation>
    </message>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>user</source>
        <translation>utilisateur</translation>
    </message>
    <message>
        <source>a step would draw too much current: the unit&apos;s own profile leads, at %1 counts/s at most</source>
        <translation>un échelon tirerait trop de courant&#xa0;: le profil de l’appareil lui-même guide, à %1 counts/s au plus</translation>
    </message>
    <message>
        <source>allow more travel, duty or current</source>
        <translation>autorisez plus de course, de rapport cyclique ou de courant</translation>
    </message>
    <message>
        <source>an answer was lost; the same again</source>
        <translation>une réponse a été perdue&#x202f;; la même chose encore une fois</translation>
    </message>
    <message>
        <source>friction takes %1 of what its current limit and its room allow, at most 60 %</source>
        <translation>le frottement prend %1 de ce que permettent sa limite de courant et sa course, au plus 60 %</translation>
    </message>
    <message>
        <source>friction takes more than half of what P makes of a step</source>
        <translation>le frottement prend plus de la moitié de ce que P tire d’un échelon</translation>
    </message>
    <message>
        <source>its own profile leads there at %1 counts/s</source>
        <translation>son propre profil y mène, à %1 counts/s</translation>
    </message>
    <message>
        <source>see whether the motor is too strong for this unit</source>
        <translation>vérifiez si le moteur est trop puissant pour cet appareil</translation>
    </message>
    <message>
        <source>the unit&apos;s own profile led at %1 counts/s, for a step would draw too much current</source>
        <translation>le profil de l’appareil lui-même guidait à %1 counts/s, car un échelon tirerait trop de courant</translation>
    </message>
    <message>
        <source>at most %1 duty, %2 counts/s and %3 counts from where it stands</source>
        <translation>au plus %1 de rapport cyclique, %2 counts/s et %3 counts depuis sa position</translation>
    </message>
    <message>
        <source>first its direction is checked: %1 counts up</source>
        <translation>d’abord son sens est vérifié&#xa0;: %1 counts vers le haut</translation>
    </message>
    <message>
        <source>its loop takes its velocity every %1 ms, every %2 ms was expected</source>
        <translation>sa boucle prend sa vitesse toutes les %1 ms, on attendait toutes les %2 ms</translation>
    </message>
    <message>
        <source>perhaps its D acts the other way round than in the firmware that is known</source>
        <translation>peut-être son D agit-il à l’inverse du micrologiciel connu</translation>
    </message>
    <message>
        <source>see which firmware it runs</source>
        <translation>vérifiez quel micrologiciel il exécute</translation>
    </message>
    <message>
        <source>a regression of mean speeds makes the lag %1, %2 beside what was fitted</source>
        <translation>une régression de vitesses moyennes donne une constante de temps de %1, à %2 de l’ajustement</translation>
    </message>
    <message>
        <source>F is 0: in a position loop it would push by where the target lies, not by how far it is</source>
        <translation>F vaut 0 : dans une boucle de position il pousserait selon la place de la cible, et non selon sa distance</translation>
    </message>
    <message>
        <source>F is 0: with an integral both would give what friction and speed take, and it would overshoot</source>
        <translation>F vaut 0 : avec une intégrale, les deux donneraient ce que prennent le frottement et la vitesse, et il y aurait un dépassement</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>c&apos;est %1</translation>
    </message>
    <message>
        <source>number %1 has another session</source>
        <translation>le numéro %1 a une autre session</translation>
    </message>
    <message>
        <source>chatter of the duty</source>
        <translation>agitation du rapport cyclique</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>codeur</translation>
    </message>
    <message>
        <source>error at rest</source>
        <translation>erreur au repos</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>frottement</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>gain</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>bruit</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>dépassement</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>pic de courant</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>résistance</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>montée</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>établissement</translation>
    </message>
    <message>
        <source>time at the duty limit</source>
        <translation>temps en limite de rapport cyclique</translation>
    </message>
    <message>
        <source>undershoot</source>
        <translation>sous-dépassement</translation>
    </message>
    <message>
        <source>%1 was cleared but reads %2</source>
        <translation>%1 a été effacé mais on lit %2</translation>
    </message>
    <message>
        <source>%1: unknown key %2</source>
        <translation>%1&#xa0;: clé inconnue %2</translation>
    </message>
    <message>
        <source>%1; the gains of the axis were not known, and are now those that the board starts with</source>
        <translation>%1&#x202f;; les gains de l’axe n’étaient pas connus et sont maintenant ceux avec lesquels la carte démarre</translation>
    </message>
    <message>
        <source>correct it, or delete its row</source>
        <translation>corrigez-la ou supprimez sa ligne</translation>
    </message>
    <message>
        <source>its cause is there again, or still</source>
        <translation>sa cause est de nouveau présente, ou l’est encore</translation>
    </message>
    <message>
        <source>the gains of axis %1 are not known here: it will be left with those that the board starts with</source>
        <translation>les gains de l’axe %1 ne sont pas connus ici&#xa0;: il gardera à la fin ceux avec lesquels la carte démarre</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target begins within %1 of where it is, and goes further as its output is seen to allow it; write its p, d and divisor once</source>
        <translation>les gains de cette boucle ne sont pas connus ici, sa cible commence donc à moins de %1 de sa position, et s’éloigne à mesure que sa sortie le permet&#x202f;; écrivez une fois son p, son d et son divisor</translation>
    </message>
    <message>
        <source>write &quot;value&quot; or &quot;raw&quot;</source>
        <translation>écrivez «&#xa0;value&#xa0;» ou «&#xa0;raw&#xa0;»</translation>
    </message>
    <message>
        <source>%1 duty makes the motor quicker than %2 counts/s, which are allowed</source>
        <translation>%1 de rapport cyclique rendent le moteur plus rapide que les %2 counts/s autorisés</translation>
    </message>
    <message>
        <source>&apos;sqlite3 %1 .recover&apos; tells what it still holds; where it is moved away, a new one is begun</source>
        <translation>&apos;sqlite3 %1 .recover&apos; montre ce qu’il contient encore ; s’il est mis de côté, un nouveau est commencé</translation>
    </message>
    <message>
        <source>another program holds it: try again when that has ended</source>
        <translation>un autre programme le tient : réessayez quand il aura fini</translation>
    </message>
    <message>
        <source>look whether its disk is there, has room and is in order</source>
        <translation>vérifiez que son disque est présent, a de la place et est en bon état</translation>
    </message>
    <message>
        <source>make room on its disk</source>
        <translation>faites de la place sur son disque</translation>
    </message>
    <message>
        <source>%1: its value is in &apos;%2&apos;, its unit is &apos;%3&apos;</source>
        <translation>%1 : sa valeur est en « %2 », son unité est « %3 »</translation>
    </message>
    <message>
        <source>write it in that unit</source>
        <translation>écrivez-la dans cette unité</translation>
    </message>
    <message>
        <source>a line has more than %1 bytes</source>
        <translation>une ligne a plus de %1 octets</translation>
    </message>
    <message>
        <source>allow more duty, speed or travel</source>
        <translation>autorisez plus de rapport cyclique, de vitesse ou de course</translation>
    </message>
    <message>
        <source>it came to %1 of its step while that was held</source>
        <translation>il n’a atteint que %1 de son échelon pendant que celui-ci était tenu</translation>
    </message>
    <message>
        <source>the pushes that its limits leave hardly moved the motor</source>
        <translation>les poussées que laissent ses limites ont à peine bougé le moteur</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target until its integral has overcome friction</source>
        <translation>il peut s’arrêter à %1 de sa cible jusqu’à ce que son intégrale ait vaincu le frottement</translation>
    </message>
    <message>
        <source>%1 has restarted and did not say yet whether it is the same unit</source>
        <translation>%1 a redémarré et n’a pas encore indiqué s’il s’agit de la même unité</translation>
    </message>
    <message>
        <source>another unit stands in its place by now</source>
        <translation>une autre unité se trouve maintenant à sa place</translation>
    </message>
    <message>
        <source>look at what it says, then order it again</source>
        <translation>regardez ce qu’elle indique, puis redonnez l’ordre</translation>
    </message>
    <message>
        <source>compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus</source>
        <translation>compilez dans son firmware un offset propre, 1 … 99, ou laissez-le seul sur le bus</translation>
    </message>
    <message>
        <source>what is sent to offset 0 is done by every drive of the bus, and others answer on this one</source>
        <translation>ce qui est envoyé à l’offset 0 est exécuté par tous les variateurs du bus, et d’autres répondent sur celui-ci</translation>
    </message>
    <message>
        <source>the board is told to tell its whole counters; look at the position, and run it again</source>
        <translation>la carte doit maintenant donner ses compteurs entiers ; regardez la position, puis relancez</translation>
    </message>
    <message>
        <source>%1 settings were written and cannot be read back</source>
        <translation>%1 réglages ont été écrits et ne peuvent pas être relus</translation>
    </message>
    <message>
        <source>1 setting was written and cannot be read back</source>
        <translation>1 réglage a été écrit et ne peut pas être relu</translation>
    </message>
    <message>
        <source>put it on again, and do it again</source>
        <translation>remettez-le en place, puis recommencez</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for a number</source>
        <translation>l’unité a été retirée pendant qu’elle attendait un numéro</translation>
    </message>
    <message>
        <source>%1 is not told as often as was asked for: %2</source>
        <translation>%1 n’est pas indiqué aussi souvent que demandé : %2</translation>
    </message>
    <message>
        <source>%1: the gains were not put back: %2</source>
        <translation>%1 : les gains n’ont pas été rétablis : %2</translation>
    </message>
    <message>
        <source>let it come to rest first</source>
        <translation>laissez-le d’abord s’immobiliser</translation>
    </message>
    <message>
        <source>no position for %1</source>
        <translation>aucune position depuis %1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1</source>
        <translation>les gains n’ont pas été rétablis : %1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1; they are offered at the next connection</source>
        <translation>les gains n’ont pas été rétablis : %1 ; ils seront proposés à la prochaine connexion</translation>
    </message>
    <message>
        <source>the shaft still turns, so nobody can tell which way it is pushed</source>
        <translation>l’arbre tourne encore, impossible donc de savoir dans quel sens il est poussé</translation>
    </message>
    <message>
        <source>the stop was not confirmed by %1</source>
        <translation>l’arrêt n’a pas été confirmé par %1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1</source>
        <translation>ce qui a été éprouvé n’a pas pu être écrit : %1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before is in force again</source>
        <translation>ce qui a été éprouvé n’a pas pu être écrit : %1 ; ce qui était là avant est de nouveau en vigueur</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before was not put back: %2; it is offered at the next connection</source>
        <translation>ce qui a été éprouvé n’a pas pu être écrit : %1 ; ce qui était là avant n’a pas été rétabli : %2 ; cela sera proposé à la prochaine connexion</translation>
    </message>
    <message>
        <source>a duty that grew to %1 did not move the motor both ways</source>
        <translation>un rapport cyclique croissant jusqu’à %1 n’a pas fait tourner le moteur dans les deux sens</translation>
    </message>
    <message>
        <source>it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)</source>
        <translation>il décolle à %1 en avant et à %2 en arrière, connus à %3 près, et demande %4 et %5 tant qu’il tourne (R² %6)</translation>
    </message>
    <message>
        <source>pushing with a duty that grows to %1 in %2 s</source>
        <translation>poussée à un rapport cyclique qui croît jusqu’à %1 en %2 s</translation>
    </message>
    <message>
        <source>there is no room for a duty that grows slowly</source>
        <translation>il n’y a pas de place pour un rapport cyclique qui croît lentement</translation>
    </message>
    <message>
        <source>%1 has a time that is more than 140 years from 1970</source>
        <translation>%1 a une heure à plus de 140 ans de 1970</translation>
    </message>
    <message>
        <source>record with the clock set</source>
        <translation>enregistrez avec une horloge réglée</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>un essai avec lui n’est pas encore terminé</translation>
    </message>
    <message>
        <source>begin a queue first</source>
        <translation>commencez d’abord une file</translation>
    </message>
    <message>
        <source>firmware is written to a unit here; the link stays open</source>
        <translation>un micrologiciel est écrit ici dans un appareil&#xa0;; la liaison reste ouverte</translation>
    </message>
    <message>
        <source>it has passed</source>
        <translation>il a réussi</translation>
    </message>
    <message>
        <source>it is being served, or waits for its turn</source>
        <translation>il est en cours de traitement ou attend son tour</translation>
    </message>
    <message>
        <source>it is not armed, or moves</source>
        <translation>il n’est pas armé, ou il bouge</translation>
    </message>
    <message>
        <source>it is not in the queue</source>
        <translation>il n’est pas dans la file</translation>
    </message>
    <message>
        <source>it was taken off</source>
        <translation>il a été retiré</translation>
    </message>
    <message>
        <source>nothing is served here</source>
        <translation>rien n’est traité ici</translation>
    </message>
    <message>
        <source>put it on again; it gets a row of its own</source>
        <translation>rebranchez-le&#xa0;; il aura sa propre ligne</translation>
    </message>
    <message>
        <source>take it off and put it on again to serve it once more</source>
        <translation>retirez-le et rebranchez-le pour le traiter encore une fois</translation>
    </message>
    <message>
        <source>wait until it has, or stop it</source>
        <translation>attendez qu’il se termine, ou arrêtez-le</translation>
    </message>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>attendez que ce soit fini, ou annulez</translation>
    </message>
    <message>
        <source>after a move with a velocity or a profile it is not known from where this distance counts</source>
        <translation>après un mouvement en vitesse ou avec profil, on ne sait pas à partir d’où compte cette distance</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the port is away</source>
        <translation>avrdude a relu les %1 octets et ils sont égaux, mais le port a disparu</translation>
    </message>
    <message>
        <source>halt it first, or give a position</source>
        <translation>arrêtez-le d’abord ou indiquez une position</translation>
    </message>
    <message>
        <source>restart the unit: its old firmware is still there</source>
        <translation>redémarrez l’appareil : son ancien micrologiciel est toujours là</translation>
    </message>
    <message>
        <source>the drive may hold half a program, and runs again once an update has succeeded</source>
        <translation>le variateur contient peut-être un demi-programme et refonctionnera dès qu’une mise à jour aura réussi</translation>
    </message>
    <message>
        <source>the motor may be %1 counts from where its loop holds it, and with this P that overflows</source>
        <translation>le moteur est peut-être à %1 points de là où sa boucle le tient, et avec ce P cela déborde</translation>
    </message>
    <message>
        <source>another adapter has this name now; what was found on the one before is not in the list any more</source>
        <translation>un autre adaptateur porte maintenant ce nom ; ce qui a été trouvé sur le précédent n&apos;est plus dans la liste</translation>
    </message>
    <message>
        <source>another adapter is called %1 now</source>
        <translation>un autre adaptateur s&apos;appelle maintenant %1</translation>
    </message>
    <message>
        <source>close the link, and open it again to see who is there</source>
        <translation>fermez la liaison et rouvrez-la pour voir qui s&apos;y trouve</translation>
    </message>
    <message>
        <source>another unit answers as number %1: serial number &apos;%2&apos; instead of &apos;%3&apos;</source>
        <translation>un autre appareil répond sous le numéro %1&#xa0;: numéro de série «&#xa0;%2&#xa0;» au lieu de «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>scan again, and update it if it is the one that is meant</source>
        <translation>relancez la recherche et mettez-le à jour si c’est bien lui</translation>
    </message>
    <message>
        <source>the unit with number %1 has another session than before, and may be another unit: its serial number was not known</source>
        <translation>l’appareil numéro %1 a une autre session qu’avant et peut être un autre appareil&#xa0;: son numéro de série n’était pas connu</translation>
    </message>
    <message>
        <source>begin it once more to serve this unit again</source>
        <translation>relancez-la pour traiter de nouveau cet appareil</translation>
    </message>
    <message>
        <source>the queue was ended</source>
        <translation>la file a été terminée</translation>
    </message>
    <message>
        <source>%1 has more than %2 MB that are no samples</source>
        <translation>%1 contient plus de %2 Mo qui ne sont pas des échantillons</translation>
    </message>
    <message>
        <source>%1 was taken away; what memory still has of it is recorded anew</source>
        <translation>%1 a disparu ; ce que la mémoire en a encore est enregistré à nouveau</translation>
    </message>
    <message>
        <source>leave that folder where it is</source>
        <translation>laissez ce dossier où il est</translation>
    </message>
    <message>
        <source>the file was deleted while it was written</source>
        <translation>le fichier a été supprimé pendant son écriture</translation>
    </message>
    <message>
        <source>write it anew</source>
        <translation>écrivez-le à nouveau</translation>
    </message>
    <message>
        <source>the kernel does not say what %1 is: a driver holds it up</source>
        <translation>le noyau ne dit pas ce qu’est %1 : un pilote le retient</translation>
    </message>
    <message>
        <source>unplug the adapter and plug it in again</source>
        <translation>débranchez l’adaptateur et rebranchez-le</translation>
    </message>
    <message>
        <source>its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of now, is so much that with its gains the output would turn to full reverse</source>
        <translation>sa boucle de vitesse commence par la vitesse moyenne depuis qu’elle a tourné pour la dernière fois&#xa0;: de %1 à %2 counts/s, avec la vitesse de maintenant, c’est tant qu’avec ses gains la sortie basculerait à fond en arrière</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or lower p</source>
        <translation>arrêtez le moteur et laissez-le immobile un moment, ou diminuez p</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or write p, d and divisor of the loop once</source>
        <translation>arrêtez le moteur et laissez-le immobile un moment, ou écrivez une fois p, d et divisor de la boucle</translation>
    </message>
    <message>
        <source>%1 has restarted, and nobody has looked at it since</source>
        <translation>%1 a redémarré, et personne ne l’a regardé depuis</translation>
    </message>
    <message>
        <source>Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Les réponses d’offset %1 sont détruites sur le bus, comme là où plusieurs variateurs l’ont et répondent à la fois&#x202f;; les offsets sont compilés dans le firmware, donnez-en donc un autre à l’un d’eux et flashez-le.</translation>
    </message>
    <message>
        <source>the notebook may offer to put back what was there before: %1</source>
        <translation>le carnet proposera peut-être de rétablir ce qui était là avant&#xa0;: %1</translation>
    </message>
    <message>
        <source>turn its shaft until its position is %1 counts away from 0, which shows that it was off, then switch it off and on</source>
        <translation>tournez son arbre jusqu&apos;à ce que sa position soit à %1 points de 0, ce qui montrera qu&apos;il a été éteint, puis éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 and at most %2</source>
        <translation>«&#xa0;%1&#xa0;» doit être supérieur à 0 et valoir au plus %2</translation>
    </message>
    <message>
        <source>nothing was written, because what is there cannot be kept: %1</source>
        <translation>rien n’a été écrit, car l’état présent ne peut pas être conservé&#xa0;: %1</translation>
    </message>
    <message>
        <source>where it is left out the unit&apos;s own limit serves</source>
        <translation>s’il est omis, la limite propre de l’appareil s’applique</translation>
    </message>
    <message>
        <source>its number holds from its next power cycle on, and nothing proves it before</source>
        <translation>son numéro vaut dès la prochaine remise sous tension, et rien ne le prouve avant</translation>
    </message>
    <message>
        <source>put it back first, as &apos;motorbenchctl set %1 %2&apos; does</source>
        <translation>le rétablir d’abord, comme le fait « motorbenchctl set %1 %2 »</translation>
    </message>
    <message>
        <source>trial %1 did not put back what it changed</source>
        <translation>l’essai %1 n’a pas rétabli ce qu’il a changé</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must not be empty</source>
        <translation>« %1 » ne doit pas être vide</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains are as they were</source>
        <translation>les échelons dans les deux sens ont respecté leurs limites ; les gains sont restés comme ils étaient</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written and read back</source>
        <translation>les échelons dans les deux sens ont respecté leurs limites ; les gains ont été écrits et relus</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written, which this family cannot read back</source>
        <translation>les échelons dans les deux sens ont respecté leurs limites ; les gains ont été écrits, mais cette famille ne permet pas de les relire</translation>
    </message>
    <message>
        <source>%1 CAN FD frames are left out, because only classic CAN is read</source>
        <translation>%1 trames CAN FD sont omises, car seul le CAN classique est lu</translation>
    </message>
    <message>
        <source>1 CAN FD frame is left out, because only classic CAN is read</source>
        <translation>1 trame CAN FD est omise, car seul le CAN classique est lu</translation>
    </message>
    <message>
        <source>a simulated board&apos;s socket has no option &apos;%1&apos;</source>
        <translation>le socket d’une carte simulée n’a pas d’option « %1 »</translation>
    </message>
    <message>
        <source>it has pace</source>
        <translation>elle a pace</translation>
    </message>
    <message>
        <source>leave one of the two out</source>
        <translation>omettez l’une des deux</translation>
    </message>
    <message>
        <source>legal are 0 and 1</source>
        <translation>0 et 1 sont admis</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is there twice</source>
        <translation>l’option « %1 » de la liaison figure deux fois</translation>
    </message>
    <message>
        <source>pace=%1 is no choice</source>
        <translation>pace=%1 n’est pas un choix</translation>
    </message>
    <message>
        <source>the last line has no end, so its frame may be cut short</source>
        <translation>la dernière ligne n’a pas de fin, sa trame peut donc être tronquée</translation>
    </message>
    <message>
        <source>the last line is cut off, and left out</source>
        <translation>la dernière ligne est coupée et omise</translation>
    </message>
    <message>
        <source>nothing proves that its flash has what was written</source>
        <translation>rien ne prouve que sa flash contient ce qui a été écrit</translation>
    </message>
    <message>
        <source>switch its supply off and on, then do it again: what is read then comes from its flash</source>
        <translation>coupez et rétablissez son alimentation, puis recommencez : ce qui est lu alors vient de sa flash</translation>
    </message>
    <message>
        <source>take it out of the recipe&apos;s parameters, or serve such units by a recipe of their own</source>
        <translation>retirez-le des paramètres de la recette, ou traitez ces appareils avec une recette à eux</translation>
    </message>
    <message>
        <source>take one of them off, then test the other again</source>
        <translation>retirez l’un d’eux, puis testez l’autre à nouveau</translation>
    </message>
    <message>
        <source>this unit does not have %1 of the recipe</source>
        <translation>cet appareil n’a pas %1 de la recette</translation>
    </message>
    <message>
        <source>two units tell the serial number %1</source>
        <translation>deux appareils annoncent le numéro de série %1</translation>
    </message>
    <message>
        <source>a stop came before it was begun</source>
        <translation>un arrêt est venu avant que cela ne commence</translation>
    </message>
    <message>
        <source>it has restarted, or a second unit has number %1: another session answers</source>
        <translation>il a redémarré, ou un second appareil a le numéro %1&#xa0;: une autre session répond</translation>
    </message>
    <message>
        <source>its position is being reset</source>
        <translation>sa position est en cours de remise à zéro</translation>
    </message>
    <message>
        <source>it did not say that it restarts, and may have done so or not</source>
        <translation>il n’a pas dit qu’il redémarre, et l’a peut-être fait ou non</translation>
    </message>
    <message>
        <source>restart it once more</source>
        <translation>redémarrez-le encore une fois</translation>
    </message>
    <message>
        <source>%1 leads to a terminal that another program serves</source>
        <translation>%1 mène à un terminal que sert un autre programme</translation>
    </message>
    <message>
        <source>%1 takes no bytes any more</source>
        <translation>%1 n’accepte plus d’octets</translation>
    </message>
    <message>
        <source>a stop that is owed cannot be written down: %1 cannot be used</source>
        <translation>un arrêt encore dû ne peut pas être noté : %1 est inutilisable</translation>
    </message>
    <message>
        <source>it must be a folder of yours that nobody else may write to</source>
        <translation>ce doit être un dossier à vous, où personne d’autre ne peut écrire</translation>
    </message>
    <message>
        <source>the simulator at %1 does not answer</source>
        <translation>le simulateur sur %1 ne répond pas</translation>
    </message>
    <message>
        <source>a limit switch was met</source>
        <translation>un fin de course a été atteint</translation>
    </message>
    <message>
        <source>no time was left to prove others</source>
        <translation>il ne restait pas de temps pour en vérifier d’autres</translation>
    </message>
    <message>
        <source>what these gains do is predicted, and not proven on the motor</source>
        <translation>ce que font ces gains est prédit et n’est pas vérifié sur le moteur</translation>
    </message>
    <message>
        <source>what was there is not known, and those that were tried are in force</source>
        <translation>on ne sait pas ce qu’il y avait, et ceux qui ont été essayés sont en vigueur</translation>
    </message>
    <message>
        <source>its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power once it may overwrite its own memory</source>
        <translation>son moyennage a été diminué ou porté au-delà de 500, pour autant qu’on le sache, et tant qu’il n’a pas été mis une fois hors tension, il peut écraser sa propre mémoire</translation>
    </message>
    <message>
        <source>stop the motor before its calibration is changed</source>
        <translation>arrêtez le moteur avant de changer son étalonnage</translation>
    </message>
    <message>
        <source>the power limit of axis %1 is %2: its motor gets no more</source>
        <translation>la limite de puissance de l’axe %1 est de %2&#xa0;: son moteur ne reçoit pas plus</translation>
    </message>
    <message>
        <source>the velocity limit of axis %1 is %2: its motor goes no faster</source>
        <translation>la limite de vitesse de l’axe %1 est de %2&#xa0;: son moteur ne va pas plus vite</translation>
    </message>
    <message>
        <source>write an averaging of 1 … 500, then switch it off and on</source>
        <translation>écrivez un moyennage de 1 … 500, puis éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on</source>
        <translation>Rien n&apos;est encore écrit. Si OpenOCD a déjà arrêté le variateur, il reste immobile : éteignez-le et rallumez-le</translation>
    </message>
    <message>
        <source>firmware is written here, or units are served; nothing was searched</source>
        <translation>un firmware est écrit ici, ou des unités sont servies ; rien n&apos;a été cherché</translation>
    </message>
    <message>
        <source>put the programmer on it, and look at the other one</source>
        <translation>branchez le programmateur dessus, et regardez l&apos;autre</translation>
    </message>
    <message>
        <source>the programmer wrote another unit: %1 answered all the while</source>
        <translation>le programmateur a écrit une autre unité : %1 a répondu pendant tout ce temps</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>attendez que ce soit terminé</translation>
    </message>
    <message>
        <source>averaging changed: it may overwrite its memory</source>
        <translation>moyennage modifié&#xa0;: il peut écraser sa mémoire</translation>
    </message>
    <message>
        <source>the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its error.level to 0 where it is 1, then scan again</source>
        <translation>le masque d’acceptation du nœud %1 n’est pas connu, il exécute donc peut-être aussi ce qui est envoyé au nœud %2&#x202f;; mettez son error.level à 0 s’il est à 1, puis relancez la recherche</translation>
    </message>
    <message>
        <source>All of it is written; whether the unit runs it is not known then</source>
        <translation>Tout est écrit&#x202f;; on ne sait alors pas si l’appareil fonctionne avec</translation>
    </message>
    <message>
        <source>%1 settings are lost with its power</source>
        <translation>%1 réglages sont perdus à la mise hors tension</translation>
    </message>
    <message>
        <source>%1 settings hold from its next power cycle on, and nothing proves them before</source>
        <translation>%1 réglages valent dès la prochaine remise sous tension, et rien ne les prouve avant</translation>
    </message>
    <message>
        <source>1 setting holds from its next power cycle on, and nothing proves it before</source>
        <translation>1 réglage vaut dès la prochaine remise sous tension, et rien ne le prouve avant</translation>
    </message>
    <message>
        <source>1 setting is lost with its power</source>
        <translation>1 réglage est perdu à la mise hors tension</translation>
    </message>
    <message>
        <source>a unit whose %1 was lowered must lose its power once before its motor may be driven</source>
        <translation>une unité dont %1 a été diminué doit être mise une fois hors tension avant que son moteur puisse être piloté</translation>
    </message>
    <message>
        <source>leave &apos;store&apos; out: its settings are lost with its power</source>
        <translation>omettez &apos;store&apos; : ses réglages sont perdus à la mise hors tension</translation>
    </message>
    <message>
        <source>leave it out of the file, or the self-test out of the recipe</source>
        <translation>omettez-le dans le fichier, ou retirez l’autotest de la recette</translation>
    </message>
    <message>
        <source>no link is open on which such units may be</source>
        <translation>aucune liaison n&apos;est ouverte sur laquelle de telles unités peuvent être</translation>
    </message>
    <message>
        <source>no unit has failed that is still there</source>
        <translation>aucune unité encore présente n&apos;a échoué</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>ouvrez-la d&apos;abord</translation>
    </message>
    <message>
        <source>the search ends here, because firmware is written or units are served; what it found stays</source>
        <translation>la recherche s’arrête ici, car un firmware est écrit ou des unités sont servies&#x202f;; ce qu’elle a trouvé reste</translation>
    </message>
    <message>
        <source>Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this bit rate only by their number, or by %1</source>
        <translation>les Abstract DC Drive si anciens qu’ils ne répondent à aucune diffusion (dialecte LL) ne sont trouvés à ce débit que par leur numéro, ou avec %1</translation>
    </message>
    <message>
        <source>interrupted before it was done</source>
        <translation>interrompu avant la fin</translation>
    </message>
    <message>
        <source>run it again to finish</source>
        <translation>relancez-le pour terminer</translation>
    </message>
    <message>
        <source>the last run of %1 was begun by another program, which still runs</source>
        <translation>la dernière exécution de %1 a été commencée par un autre programme, qui tourne encore</translation>
    </message>
    <message>
        <source>a drive of dialect LL hears its stop, too, and would be started by it</source>
        <translation>un variateur de dialecte LL entend aussi son arrêt et serait démarré par lui</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grossier</translation>
    </message>
    <message>
        <source>current limit</source>
        <translation>limite de courant</translation>
    </message>
    <message>
        <source>derivative noise</source>
        <translation>bruit de dérivée</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>n’a pas bougé</translation>
    </message>
    <message>
        <source>do it once more if it is the same</source>
        <translation>refaites-le si c’est le même</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>écart maximal</translation>
    </message>
    <message>
        <source>limit switch</source>
        <translation>fin de course</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>marge</translation>
    </message>
    <message>
        <source>not symmetric</source>
        <translation>non symétrique</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampe</translation>
    </message>
    <message>
        <source>restart needed</source>
        <translation>redémarrage requis</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>échantillons perdus</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturé</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>arrêt non confirmé</translation>
    </message>
    <message>
        <source>stopped before its motor turned</source>
        <translation>arrêté avant que son moteur ne tourne</translation>
    </message>
    <message>
        <source>the unit tells no current in ampere: the duty limit stands in for %1 A</source>
        <translation>l’appareil ne donne pas de courant en ampères : la limite de rapport cyclique remplace %1 A</translation>
    </message>
    <message>
        <source>this place, not this unit: what is kept may be of another</source>
        <translation>cet emplacement, pas cet appareil : ce qui est conservé peut être d’un autre</translation>
    </message>
    <message>
        <source>%1 answers, and a programmer would not tell them apart: take all others off the line</source>
        <translation>%1 répond, et un programmateur ne saurait pas les distinguer&#xa0;: retirez tous les autres de la ligne</translation>
    </message>
    <message>
        <source>P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative divisor keeps the integral across modes: to reverse the loop, change the signs of P, I and D.</source>
        <translation>P, I et D sont divisés par lui. Une flash vierge contient 0, avec quoi aucune boucle ne marche&#x202f;; 0 n’est jamais écrit. Un diviseur négatif garde l’intégrale d’un mode à l’autre&#x202f;: pour inverser la boucle, changez les signes de P, I et D.</translation>
    </message>
    <message>
        <source>Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a standstill. Once lowered, the drive must lose its power for a moment before it is driven.</source>
        <translation>Échantillons de 20 ms dans une moyenne du courant, qui est fausse tant qu’il n’y en a pas eu autant&#x202f;: on la change moteur à l’arrêt. Après une diminution, l’alimentation du variateur doit être brièvement coupée avant de le piloter.</translation>
    </message>
    <message>
        <source>%1 cannot blink</source>
        <translation>%1 ne peut pas clignoter</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 n’a pas de nom</translation>
    </message>
    <message>
        <source>choose a free one</source>
        <translation>choisissez-en un libre</translation>
    </message>
    <message>
        <source>lower them, or raise the divisor</source>
        <translation>diminuez-les, ou augmentez le diviseur</translation>
    </message>
    <message>
        <source>no device of %1 can have the fault &apos;%2&apos;</source>
        <translation>aucun appareil de %1 ne peut avoir le défaut « %2 »</translation>
    </message>
    <message>
        <source>p and d are so high for the divisor that an error of 1 turns the output to full reverse</source>
        <translation>p et d sont si grands pour le diviseur qu’un écart de 1 fait basculer la sortie à fond en arrière</translation>
    </message>
    <message>
        <source>the motor is so far from its target that with this value the output would turn to full reverse</source>
        <translation>le moteur est si loin de sa cible qu’avec cette valeur la sortie basculerait à fond en arrière</translation>
    </message>
    <message>
        <source>until it has averaged once it reads a wrong current</source>
        <translation>tant qu’il n’a pas fait une moyenne complète, il lit un courant faux</translation>
    </message>
    <message>
        <source>give --velocity, or write a lower profile.velocity</source>
        <translation>indiquez --velocity ou écrivez un profile.velocity plus bas</translation>
    </message>
    <message>
        <source>somebody searches here already</source>
        <translation>quelqu’un cherche déjà ici</translation>
    </message>
    <message>
        <source>%1 no longer goes back by itself: the unit was gone or has restarted</source>
        <translation>%1 n’est plus rétabli automatiquement : l’unité avait disparu ou a redémarré</translation>
    </message>
    <message>
        <source>at most %1 counts/s with its P</source>
        <translation>au plus %1 counts/s avec son P</translation>
    </message>
    <message>
        <source>its adapter has another name now; what was found under this one is not in the list any more</source>
        <translation>son adaptateur porte maintenant un autre nom ; ce qui a été trouvé sous celui-ci n&apos;est plus dans la liste</translation>
    </message>
    <message>
        <source>node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is written</source>
        <translation>le nœud %1 est aussi sur cette ligne : il entend ce qui est dit au bootloader, et c’est peut-être lui qui est écrit</translation>
    </message>
    <message>
        <source>take all others off the line and scan it, or use a programmer on the pins</source>
        <translation>retirez tous les autres de la ligne et relancez-y la recherche, ou utilisez un programmateur sur les broches</translation>
    </message>
    <message>
        <source>%1 cannot be told to brake or to coast</source>
        <translation>on ne peut pas indiquer à %1 de freiner ou de rester en roue libre</translation>
    </message>
    <message>
        <source>%1 cannot exchange directions</source>
        <translation>%1 ne peut pas permuter les sens</translation>
    </message>
    <message>
        <source>%1 has no limit override</source>
        <translation>%1 ne peut pas ignorer les limites</translation>
    </message>
    <message>
        <source>%1 has no ramp of the output in mode &apos;%2&apos;</source>
        <translation>%1 n’a pas de rampe de sortie en mode « %2 »</translation>
    </message>
    <message>
        <source>docs/bench.md has the options of each family, and what they take</source>
        <translation>docs/bench.md donne les options de chaque famille et leurs valeurs</translation>
    </message>
    <message>
        <source>it is being recorded or replayed</source>
        <translation>il est en cours d’enregistrement ou de lecture</translation>
    </message>
    <message>
        <source>name a notebook that can be written</source>
        <translation>indiquez un carnet dans lequel on peut écrire</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is there twice</source>
        <translation>l’option « %1 » figure deux fois</translation>
    </message>
    <message>
        <source>seed and bitrate are whole numbers, loss is a fraction below 1</source>
        <translation>seed et bitrate sont des nombres entiers, loss est une fraction inférieure à 1</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is of &apos;%2&apos;</source>
        <translation>le fichier est destiné à la famille « %1 », l’appareil est de « %2 »</translation>
    </message>
    <message>
        <source>the rest of its disk is left to others</source>
        <translation>le reste de son disque est laissé aux autres</translation>
    </message>
    <message>
        <source>%1 keeps no setting without power</source>
        <translation>%1 ne garde aucun réglage hors tension</translation>
    </message>
    <message>
        <source>cut its power and try again after 10 minutes, or look at it and say in the window that it stands</source>
        <translation>couper l’alimentation et réessayer après 10 minutes, ou vérifier et confirmer dans la fenêtre qu’il est à l’arrêt</translation>
    </message>
    <message>
        <source>the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is dead</source>
        <translation>le moteur n’a pas bougé quand on l’a envoyé %1 counts plus haut (%2 counts)&#xa0;: bloqué, ou le codeur est mort</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe and that its time is enough, then test again</source>
        <translation>vérifiez que moteur et charge sont ceux de la recette et que sa durée suffit, puis testez à nouveau</translation>
    </message>
    <message>
        <source>%1 is %2 of its smallest steps, fewer than %3: one of them is %4</source>
        <translation>%1 vaut %2 de ses plus petits pas, moins de %3 : un seul fait %4</translation>
    </message>
    <message>
        <source>allow more current or aim for a calmer loop</source>
        <translation>autorisez plus de courant ou visez une boucle plus calme</translation>
    </message>
    <message>
        <source>any step of these gains draws more than the %1 A that are allowed</source>
        <translation>tout échelon avec ces gains consomme plus que les %1 A permis</translation>
    </message>
    <message>
        <source>at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet</source>
        <translation>au plus %1 de rapport cyclique et %2 counts depuis sa position, à une vitesse que personne ne connaît encore</translation>
    </message>
    <message>
        <source>first its direction is checked: pushes of 0.3 s, until it turns</source>
        <translation>d’abord son sens est vérifié : poussées de 0,3 s, jusqu’à ce qu’il tourne</translation>
    </message>
    <message>
        <source>no gains as the device stores them keep a largest sensitivity of %1 in this loop</source>
        <translation>aucun gain tel que l’appareil l’enregistre ne garde une sensibilité maximale de %1 dans cette boucle</translation>
    </message>
    <message>
        <source>left out before it was done</source>
        <translation>laissé de côté avant la fin</translation>
    </message>
    <message>
        <source>load 9 × rotor inertia · 4096 counts a turn</source>
        <translation>charge 9 × l’inertie du rotor · 4096 incréments par tour</translation>
    </message>
    <message>
        <source>4096 counts a turn</source>
        <translation>4096 incréments par tour</translation>
    </message>
    <message>
        <source>reset it without the jumper of its bootloader</source>
        <translation>réinitialisez-le sans le cavalier de son bootloader</translation>
    </message>
    <message>
        <source>N20 geared</source>
        <translation>N20 avec réducteur</translation>
    </message>
    <message>
        <source>gear 75.81:1 · 32768 counts a turn</source>
        <translation>réducteur 75,81:1 · 32768 incréments par tour</translation>
    </message>
    <message>
        <source>%1; update it</source>
        <translation>%1 ; mettez-le à jour</translation>
    </message>
    <message>
        <source>%1; update it, or %2</source>
        <translation>%1 ; mettez-le à jour, ou %2</translation>
    </message>
    <message>
        <source>nothing answers: no power, wrong wiring, another rate, or no program that runs</source>
        <translation>rien ne répond : pas d’alimentation, mauvais câblage, un autre débit ou aucun programme qui tourne</translation>
    </message>
    <message>
        <source>stored, and the unit has proved it</source>
        <translation>mémorisé, et l’appareil l’a prouvé</translation>
    </message>
    <message>
        <source>the device did not write its flash within %1 s</source>
        <translation>l’appareil n’a pas écrit sa flash en %1 s</translation>
    </message>
    <message>
        <source>%1 is busy: %2</source>
        <translation>%1 est occupé&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 is driven already</source>
        <translation>%1 est déjà piloté</translation>
    </message>
    <message>
        <source>%1 is not armed</source>
        <translation>%1 n’est pas armé</translation>
    </message>
    <message>
        <source>%1 keeps its last set-point for ever: it has no watchdog</source>
        <translation>%1 garde sa dernière consigne indéfiniment&#xa0;: il n’a pas de chien de garde</translation>
    </message>
    <message>
        <source>assign one a new number first</source>
        <translation>attribuez d’abord un nouveau numéro à l’un d’eux</translation>
    </message>
    <message>
        <source>drive it from the Tune page</source>
        <translation>pilotez-le depuis la page Réglage</translation>
    </message>
    <message>
        <source>halt it first</source>
        <translation>arrêtez-le d’abord</translation>
    </message>
    <message>
        <source>no %1 is known on this link, so STOP could not reach it</source>
        <translation>aucun %1 n’est connu sur cette liaison, STOP ne pourrait pas l’atteindre</translation>
    </message>
    <message>
        <source>no open CAN link is shown</source>
        <translation>aucune liaison CAN ouverte n’est affichée</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>ouvrez-en une d’abord</translation>
    </message>
    <message>
        <source>scan first</source>
        <translation>lancez d’abord une recherche</translation>
    </message>
    <message>
        <source>select it, then hold Arm in the header</source>
        <translation>sélectionnez-le, puis maintenez Armer dans l’en-tête</translation>
    </message>
    <message>
        <source>they were proven by %1 steps instead of %2</source>
        <translation>%1 échelons au lieu de %2 les ont éprouvés</translation>
    </message>
    <message>
        <source>two units answer as %1</source>
        <translation>deux appareils répondent comme %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>is told no more to stop after 10 minutes: the motor may still turn, cut its power</source>
        <translation>ne reçoit plus d’arrêt après 10 minutes&#xa0;: le moteur tourne peut-être encore, coupez son alimentation</translation>
    </message>
    <message>
        <source>no time was left to do the same again</source>
        <translation>il ne restait pas de temps pour refaire la même chose</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1 : %2 → %3</translation>
    </message>
    <message>
        <source>%1: ? → %2</source>
        <translation>%1 : ? → %2</translation>
    </message>
    <message>
        <source>allow all of it within little travel, or tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>autorisez-le en entier avec peu de course, ou réglez à la main avec 'motorbenchctl step'</translation>
    </message>
    <message>
        <source>allow more duty or aim for a calmer loop</source>
        <translation>autorisez plus de rapport cyclique ou visez une boucle plus calme</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, which its allowable error lets it</source>
        <translation>il peut s’arrêter à %1 de sa cible, ce que permet son erreur admissible</translation>
    </message>
    <message>
        <source>nothing of its own keeps a position loop of %1 to %2 duty</source>
        <translation>rien en propre ne tient une boucle de position de %1 à %2 de rapport cyclique</translation>
    </message>
    <message>
        <source>others that may leave less error were given up: %1</source>
        <translation>d’autres, qui laisseraient peut-être moins d’erreur, ont été abandonnés&#xa0;: %1</translation>
    </message>
    <message>
        <source>take a larger response</source>
        <translation>prenez une réponse plus longue</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no limit of its own that keeps it to them</source>
        <translation>le plus petit échelon qui prouve ces gains donne %1 de rapport cyclique, %2 sont permis, et l’unité n’a pas de limite propre qui l’y tienne</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains takes %1 counts of travel, %2 are allowed</source>
        <translation>le plus petit échelon qui prouve ces gains demande %1 counts de course, %2 sont permis</translation>
    </message>
    <message>
        <source>these are given up: %1</source>
        <translation>ceux-ci sont abandonnés&#xa0;: %1</translation>
    </message>
    <message>
        <source>these gains would overshoot by %1, and at most %2 are kept</source>
        <translation>ces gains dépasseraient de %1, et au plus %2 sont gardés</translation>
    </message>
    <message>
        <source>they would put out more duty than is allowed</source>
        <translation>ils donneraient plus de rapport cyclique que permis</translation>
    </message>
    <message>
        <source>whether gains of an experiment are still to be put back is not known yet: %1</source>
        <translation>on ne sait pas encore si des gains d’un essai restent à rétablir&#xa0;: %1</translation>
    </message>
</context>
</TS>
