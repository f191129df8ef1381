<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About Bask</source>
        <translation>À propos de Bask</translation>
    </message>
    <message>
        <source>Radiation-based thermal servoing: a robot brings objects to their temperatures by holding them in front of a heat source.</source>
        <translation>Asservissement thermique par rayonnement&#xa0;: un robot amène des objets à leurs températures en les tenant devant une source de chaleur.</translation>
    </message>
    <message>
        <source>Qt %1 on %2. Licence: GPL-3.0-or-later.</source>
        <translation>Qt %1 sur %2. Licence&#xa0;: GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>&quot;Stop, then close&quot; switches the heat off, takes the objects away from the source, and closes when they are there. &quot;Close now&quot; switches the heat off and leaves the objects where they are, perhaps close to a hot source. What is recorded stays.</source>
        <translation>« Arrêter, puis fermer » coupe la chauffe, éloigne les objets de la source, et ferme quand ils y sont. « Fermer maintenant » coupe la chauffe et laisse les objets où ils sont, peut-être près d’une source brûlante. Ce qui est enregistré reste.</translation>
    </message>
    <message>
        <source>A recipe is on, with nothing heated or moved just now.</source>
        <translation>Une recette est en cours, sans chauffe ni mouvement en ce moment.</translation>
    </message>
    <message>
        <source>The recipe ends, and its other steps are not run.</source>
        <translation>La recette prend fin, ses autres étapes n’ont pas lieu.</translation>
    </message>
    <message>
        <source>A run is on</source>
        <translation>Un essai est en cours</translation>
    </message>
    <message>
        <source>A recipe is on</source>
        <translation>Une recette est en cours</translation>
    </message>
    <message>
        <source>Stop, then close</source>
        <translation>Arrêter, puis fermer</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>Fermer maintenant</translation>
    </message>
    <message>
        <source>End the recipe and close</source>
        <translation>Terminer la recette et fermer</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Rester</translation>
    </message>
    <message>
        <source>The heat is not known to be off</source>
        <translation>Le chauffage n’est pas connu comme éteint</translation>
    </message>
    <message>
        <source>The heat source was told to switch off and has not said that it is off. Look at the plate, and switch it off at its mains.</source>
        <translation>La source de chaleur a reçu l’ordre de s’éteindre et n’a pas dit qu’elle est éteinte. Regardez la plaque et coupez-la au secteur.</translation>
    </message>
    <message>
        <source>A guard process goes on switching off a heater on a serial port after Bask has closed. The alarm is there again at the next start.</source>
        <translation>Un processus de garde continue d’éteindre une source sur un port série après la fermeture de Bask. L’alarme est de nouveau là au prochain démarrage.</translation>
    </message>
    <message>
        <source>An export is being written</source>
        <translation>Un export est en cours d’écriture</translation>
    </message>
    <message>
        <source>Bask is still writing what is named below. If it closes now, some of it may be missing; no file is left half written.</source>
        <translation>Bask écrit encore ce qui est nommé ci-dessous. S’il se ferme maintenant, il peut en manquer une partie ; aucun fichier ne reste écrit à moitié.</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Fermer quand même</translation>
    </message>
    <message>
        <source>The recording is on</source>
        <translation>L’enregistrement est en cours</translation>
    </message>
    <message>
        <source>If Bask is closed now, the recording ends. What is recorded stays.</source>
        <translation>Si Bask est fermé maintenant, l’enregistrement se termine. Ce qui est enregistré est conservé.</translation>
    </message>
</context>
<context>
    <name>Column</name>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>Températures</translation>
    </message>
    <message>
        <source>Measured temperatures. Dashed: targets; grey: the band of %1 about them. Gaps: no valid reading. The numbers at dotted lines are those of the table of events.</source>
        <translation>Températures mesurées. En tirets : les consignes ; en gris : la bande de %1 autour d’elles. Interruptions : pas de mesure valable. Les numéros aux lignes pointillées sont ceux du tableau des événements.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Measured temperature minus target, within %1; grey: the band.</source>
        <translation>Température mesurée moins consigne, entre %1 ; en gris : la bande.</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>Vitesses</translation>
    </message>
    <message>
        <source>View factor</source>
        <translation>Facteur de forme</translation>
    </message>
    <message>
        <source>View factors</source>
        <translation>Facteurs de forme</translation>
    </message>
    <message>
        <source>View factor of the source from each object.</source>
        <translation>Facteur de forme de la source vue de chaque objet.</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Ombre</translation>
    </message>
    <message>
        <source>Share of the source&apos;s light that other objects, fixtures and shields take from each object.</source>
        <translation>Part de la lumière de la source que d’autres objets, supports et écrans prennent à chaque objet.</translation>
    </message>
    <message>
        <source>Estimated λ₁</source>
        <translation>λ₁ estimé</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>Estimations</translation>
    </message>
</context>
<context>
    <name>Controller</name>
    <message>
        <source>Level servo</source>
        <translation>Asservissement de niveau</translation>
    </message>
    <message>
        <source>Moves to the view factor each object needs; learns the rates on the way.</source>
        <translation>Rejoint le facteur de forme dont chaque objet a besoin&#xa0;; apprend les vitesses en chemin.</translation>
    </message>
    <message>
        <source>Model-based</source>
        <translation>À modèle</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptatif</translation>
    </message>
    <message>
        <source>The paper&apos;s law with adapted heat rates.</source>
        <translation>La loi de l’article à coefficients thermiques adaptés.</translation>
    </message>
    <message>
        <source>The paper&apos;s law with known heat rates: dv/dt = −D v − K Δτ.</source>
        <translation>La loi de l’article à coefficients thermiques connus : dv/dt = −D v − K Δτ.</translation>
    </message>
</context>
<context>
    <name>Damage</name>
    <message>
        <source>it is cut short</source>
        <translation>il est tronqué</translation>
    </message>
    <message>
        <source>a sample is missing</source>
        <translation>il manque un échantillon</translation>
    </message>
    <message>
        <source>it does not say whether the rig was simulated</source>
        <translation>il ne dit pas si le banc était simulé</translation>
    </message>
    <message>
        <source>its database is not whole</source>
        <translation>sa base de données n’est pas intacte</translation>
    </message>
    <message>
        <source>it has a format number that no version has</source>
        <translation>il a un numéro de format qu’aucune version n’a</translation>
    </message>
    <message>
        <source>the header of its database was written over</source>
        <translation>l’en-tête de sa base de données a été écrasé</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>thermometer</source>
        <translation>thermomètre</translation>
    </message>
    <message>
        <source>heat source</source>
        <translation>source de chaleur</translation>
    </message>
    <message>
        <source>heat source kept by hand</source>
        <translation>source chauffée à la main</translation>
    </message>
    <message>
        <source>source temperature</source>
        <translation>température de la source</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>caméra thermique</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>Restore all devices</source>
        <translation>Rétablir tous les appareils</translation>
    </message>
    <message>
        <source>Sensor lost</source>
        <translation>Perte d’un capteur</translation>
    </message>
    <message>
        <source>Sensor open</source>
        <translation>Capteur ouvert</translation>
    </message>
    <message>
        <source>Sensor shorted</source>
        <translation>Capteur en court-circuit</translation>
    </message>
    <message>
        <source>Sensor frozen</source>
        <translation>Capteur figé</translation>
    </message>
    <message>
        <source>Sensor jumping</source>
        <translation>Capteur qui saute</translation>
    </message>
    <message>
        <source>Sensor off its object</source>
        <translation>Capteur décollé</translation>
    </message>
    <message>
        <source>Object heated otherwise</source>
        <translation>Objet chauffé autrement</translation>
    </message>
    <message>
        <source>Robot lost</source>
        <translation>Perte du robot</translation>
    </message>
    <message>
        <source>Robot in alarm</source>
        <translation>Robot en alarme</translation>
    </message>
    <message>
        <source>Robot restarted</source>
        <translation>Robot redémarré</translation>
    </message>
    <message>
        <source>Robot slow</source>
        <translation>Robot lent</translation>
    </message>
    <message>
        <source>Heat source lost</source>
        <translation>Perte de la source de chaleur</translation>
    </message>
    <message>
        <source>Heat source without temperature</source>
        <translation>Source sans température</translation>
    </message>
    <message>
        <source>Heat source does not heat</source>
        <translation>La source ne chauffe pas</translation>
    </message>
    <message>
        <source>Heat source heats unasked</source>
        <translation>La source chauffe sans ordre</translation>
    </message>
    <message>
        <source>Heat source overheats</source>
        <translation>La source surchauffe</translation>
    </message>
    <message>
        <source>Heat source limited by itself</source>
        <translation>Source limitée par elle-même</translation>
    </message>
    <message>
        <source>Heat source cannot be switched off</source>
        <translation>La source ne s’éteint plus</translation>
    </message>
    <message>
        <source>Source hidden from the camera</source>
        <translation>Source cachée à la caméra</translation>
    </message>
    <message>
        <source>Camera lost</source>
        <translation>Caméra perdue</translation>
    </message>
    <message>
        <source>Sensors swapped with the next object</source>
        <translation>Capteurs échangés avec l’objet suivant</translation>
    </message>
</context>
<context>
    <name>MaterialPreset</name>
    <message>
        <source>aluminium, painted black</source>
        <translation>aluminium peint en noir</translation>
    </message>
    <message>
        <source>aluminium, anodised</source>
        <translation>aluminium anodisé</translation>
    </message>
    <message>
        <source>copper, polished</source>
        <translation>cuivre poli</translation>
    </message>
    <message>
        <source>steel, painted black</source>
        <translation>acier peint en noir</translation>
    </message>
    <message>
        <source>stainless steel, polished</source>
        <translation>acier inoxydable poli</translation>
    </message>
    <message>
        <source>stainless steel, oxidised</source>
        <translation>acier inoxydable oxydé</translation>
    </message>
    <message>
        <source>ABS, 30 % infill</source>
        <translation>ABS, remplissage 30 %</translation>
    </message>
    <message>
        <source>graphite</source>
        <translation>graphite</translation>
    </message>
    <message>
        <source>cardboard</source>
        <translation>carton</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147 (bulk), flat paint (surface)</source>
        <translation>Hu et al., arXiv 2012.13147 (masse), peinture mate (surface)</translation>
    </message>
    <message>
        <source>aluminium, painted</source>
        <translation>aluminium peint</translation>
    </message>
    <message>
        <source>aluminium, bare</source>
        <translation>aluminium nu</translation>
    </message>
    <message>
        <source>PLA, 30 % infill</source>
        <translation>PLA, remplissage 30&#xa0;%</translation>
    </message>
    <message>
        <source>PLA, 50 % infill</source>
        <translation>PLA, remplissage 50&#xa0;%</translation>
    </message>
    <message>
        <source>PLA, solid</source>
        <translation>PLA plein</translation>
    </message>
    <message>
        <source>ABS, solid</source>
        <translation>ABS plein</translation>
    </message>
    <message>
        <source>copper, oxidised</source>
        <translation>cuivre oxydé</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>verre</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>Incropera, table A.1 (masse), tables FLIR : laque noire mate (surface)</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), Neutrium: anodised, 20 °C (surface)</source>
        <translation>Incropera, table A.1 (masse), Neutrium : anodisé, 20 °C (surface)</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: sheet as received (surface)</source>
        <translation>Incropera, table A.1 (masse), tables FLIR : tôle brute (surface)</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147; FLIR tables: 0.04 to 0.06, polished</source>
        <translation>Hu et al., arXiv 2012.13147 ; tables FLIR : 0,04 à 0,06, poli</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables (surface)</source>
        <translation>Incropera, table A.1 (masse), tables FLIR (surface)</translation>
    </message>
    <message>
        <source>AISI 1010, Matmake (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>AISI 1010, Matmake (masse), tables FLIR : laque noire mate (surface)</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Trotec: 18-8, 25 °C (surface)</source>
        <translation>EN 10088-1, 1.4301 (masse), Trotec : 18-8, 25 °C (surface)</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Thome, EPFL: 0.5 to 0.7 after heating (surface)</source>
        <translation>EN 10088-1, 1.4301 (masse), Thome, EPFL : 0,5 à 0,7 après chauffage (surface)</translation>
    </message>
    <message>
        <source>FreeCAD card PLA-Generic (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>fiche FreeCAD PLA-Generic (masse), plastiques : 0,85 à 0,95 (surface)</translation>
    </message>
    <message>
        <source>Kaiao, Granta Design (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>Kaiao, Granta Design (masse), plastiques : 0,85 à 0,95 (surface)</translation>
    </message>
    <message>
        <source>Pilkington ATS-129; specific heat: tables say 720 to 880 J/(kg·K)</source>
        <translation>Pilkington ATS-129 ; chaleur massique : 720 à 880 J/(kg·K) selon les tables</translation>
    </message>
    <message>
        <source>Entegris, by FreeCAD&apos;s card (bulk), tables: 0.8 to 0.98 (surface)</source>
        <translation>Entegris, d’après la fiche FreeCAD (masse), tables : 0,8 à 0,98 (surface)</translation>
    </message>
    <message>
        <source>Ashby: 480 to 860 kg/m³ (bulk), FLIR tables: paper (surface)</source>
        <translation>Ashby : 480 à 860 kg/m³ (masse), tables FLIR : papier (surface)</translation>
    </message>
    <message>
        <source>aluminium, polished</source>
        <translation>aluminium poli</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>Incertitude type&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>&quot;%1&quot; is not the finite number or numbers that it should be</source>
        <translation>« %1 » n’est pas le ou les nombres finis attendus</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading: the run is ended</source>
        <translation>En pause depuis plus de %1 s sans mesure : l’essai prend fin</translation>
    </message>
    <message>
        <source>a recipe needs at least one step that runs an experiment</source>
        <translation>une recette a besoin d’au moins une étape qui exécute une expérience</translation>
    </message>
    <message>
        <source>not one of Bask&apos;s files, or a damaged one: it is no valid JSON (%1)</source>
        <translation>ce n’est pas un fichier de Bask, ou il est endommagé : JSON non valable (%1)</translation>
    </message>
    <message>
        <source>simulated fault of &quot;%2&quot;: %1</source>
        <translation>défaut simulé de « %2 » : %1</translation>
    </message>
    <message>
        <source>simulated fault: %1</source>
        <translation>défaut simulé : %1</translation>
    </message>
    <message>
        <source>the camera matrix cannot be used: nine numbers fx 0 cx, 0 fy cy, 0 0 1 with focal lengths above zero are needed</source>
        <translation>la matrice de la caméra est inutilisable : il faut neuf nombres fx 0 cx, 0 fy cy, 0 0 1, avec des focales supérieures à zéro</translation>
    </message>
    <message>
        <source>a distortion of %1 coefficients cannot be used; 4, 5 or 8 can</source>
        <translation>une distorsion à %1 coefficients est inutilisable ; il en faut 4, 5 ou 8</translation>
    </message>
    <message>
        <source>the camera was calibrated with pictures of %1 pixels, this one has %2; calibrate it at this size</source>
        <translation>la caméra a été étalonnée avec des images de %1 pixels, celle-ci en a %2 ; étalonnez-la à cette taille</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not %2 digits 0 or 1</source>
        <translation>« %1 » n’est pas une suite de %2 chiffres 0 ou 1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no board; write chessboard:9x6:0.025 (inner corners, square in m) or charuco:5x7:0.04:0.02:6X6_250 (squares, square and marker in m, dictionary)</source>
        <translation>« %1 » n’est pas une mire ; écrivez chessboard:9x6:0.025 (coins intérieurs, case en m) ou charuco:5x7:0.04:0.02:6X6_250 (cases, case et marqueur en m, dictionnaire)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no marker; write marker:6X6_250:23:0.05 (dictionary, id, side in m)</source>
        <translation>« %1 » n’est pas un marqueur ; écrivez marker:6X6_250:23:0.05 (dictionnaire, numéro, côté en m)</translation>
    </message>
    <message>
        <source>a marker of %1 m does not fit into a square of %2 m</source>
        <translation>un marqueur de %1 m ne tient pas dans une case de %2 m</translation>
    </message>
    <message>
        <source>dictionary %1 has %2 markers; %3 are needed</source>
        <translation>le dictionnaire %1 a %2 marqueurs ; il en faut %3</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen; it needs to be whole in the picture, flat, with a light margin</source>
        <translation>aucun échiquier à %1 coins intérieurs n’est vu ; il doit être entier dans l’image, plan, avec une marge claire</translation>
    </message>
    <message>
        <source>only %1 corners of the board are seen; %2 that are not in one line are needed</source>
        <translation>seuls %1 coins de la mire sont vus ; il en faut %2 qui ne soient pas alignés</translation>
    </message>
    <message>
        <source>the pictures show the board %1, not %2; correct the setting</source>
        <translation>les images montrent la mire %1, non %2 ; corrigez le réglage</translation>
    </message>
    <message>
        <source>the picture has %1 pixels, the others %2; take all with one camera at one size</source>
        <translation>l’image a %1 pixels, les autres %2 ; prenez-les toutes avec une caméra à une seule taille</translation>
    </message>
    <message>
        <source>%1 pictures that can be used are too few; at least %2 are needed, with the board tilted in different ways</source>
        <translation>%1 images utilisables ne suffisent pas ; il en faut au moins %2, la mire inclinée de différentes façons</translation>
    </message>
    <message>
        <source>in all pictures the board is seen straight on, tilted by %1 degrees at most; at least %2 are needed to tell the focal length</source>
        <translation>dans toutes les images la mire est vue de face, inclinée de %1 degrés au plus ; il en faut au moins %2 pour connaître la focale</translation>
    </message>
    <message>
        <source>in all pictures the board is held in nearly the same direction, turned by %1 degrees at most between two of them; at least %2 are needed to tell the focal length</source>
        <translation>dans toutes les images la mire a presque la même orientation, avec %1 degrés au plus entre deux d’entre elles ; il en faut au moins %2 pour connaître la focale</translation>
    </message>
    <message>
        <source>no camera explains these pictures; tilt the board in different ways and check its setting</source>
        <translation>aucune caméra n’explique ces images ; inclinez la mire de différentes façons et vérifiez son réglage</translation>
    </message>
    <message>
        <source>the focal length is known to %1 % only; at most %2 % can be used, so add pictures with the board tilted in different ways</source>
        <translation>la focale n’est connue qu’à %1 % ; %2 % au plus conviennent, ajoutez donc des images où la mire est inclinée de différentes façons</translation>
    </message>
    <message>
        <source>the pictures contradict one another by %1 px; at most %2 px can be used, so check that the board is flat, its setting right and all pictures from one camera</source>
        <translation>les images se contredisent de %1 px ; %2 px au plus conviennent, vérifiez donc que la mire est plane, son réglage juste et que toutes les images viennent d’une même caméra</translation>
    </message>
    <message>
        <source>%1 mm are needed with margins, %2 has room for %3 mm; take larger paper or a smaller pattern</source>
        <translation>il faut %1 mm avec les marges, %2 n’offre que %3 mm ; prenez un papier plus grand ou un motif plus petit</translation>
    </message>
    <message>
        <source>the file does not say which camera it came from; name the camera&apos;s profile</source>
        <translation>le fichier ne dit pas de quelle caméra il vient ; indiquez le profil de la caméra</translation>
    </message>
    <message>
        <source>a frame of &quot;%1&quot; has %2 bytes, this one has %3; choose the profile of the camera that it came from, or record it again</source>
        <translation>une image de « %1 » a %2 octets, celle-ci en a %3 ; choisissez le profil de la caméra dont elle vient, ou enregistrez-la de nouveau</translation>
    </message>
    <message>
        <source>the number %1 at column %2, row %3 does not fit into %4 bits; the byte order, or the profile, is another camera&apos;s</source>
        <translation>le nombre %1 à la colonne %2, ligne %3, ne tient pas dans %4 bits ; l’ordre des octets, ou le profil, est celui d’une autre caméra</translation>
    </message>
    <message>
        <source>%1 % of the pixels are outside of %2 to %3, which is all that &quot;%4&quot; can tell; switch the camera to radiometric output (linear in temperature), or choose another profile</source>
        <translation>%1 % des pixels sont hors de %2 à %3, tout ce que « %4 » peut indiquer ; passez la caméra en sortie radiométrique (linéaire en température), ou choisissez un autre profil</translation>
    </message>
    <message>
        <source>%1 pixels are above %2, where the numbers of &quot;%3&quot; are known to be wrong for some cameras; check them with another thermometer</source>
        <translation>%1 pixels sont au-dessus de %2, où les nombres de « %3 » sont faux pour certaines caméras ; vérifiez-les avec un autre thermomètre</translation>
    </message>
    <message>
        <source>all pixels of the picture have one value; the camera&apos;s shutter is closed, or it sends no picture</source>
        <translation>tous les pixels de l’image ont la même valeur ; l’obturateur de la caméra est fermé, ou elle n’envoie pas d’image</translation>
    </message>
    <message>
        <source>%1 pixels are outside of what the camera can tell, the first at column %2, row %3, so the temperatures of the whole picture are not known; ask for regions, or take a lower gain</source>
        <translation>%1 pixels sont hors de ce que la caméra peut indiquer, le premier à la colonne %2, ligne %3 : les températures de l’image entière ne sont pas connues ; demandez des régions, ou prenez un gain plus faible</translation>
    </message>
    <message>
        <source>one channel of 16 bits is needed, and this picture has %1; save the camera&apos;s numbers, not the colours that it shows</source>
        <translation>il faut un seul canal de 16 bits, et cette image a %1 ; enregistrez les nombres de la caméra, pas les couleurs qu’elle montre</translation>
    </message>
    <message>
        <source>a picture of &quot;%1&quot; has %2 pixels, this one has %3; choose the profile of the camera that it came from</source>
        <translation>une image de « %1 » a %2 pixels, celle-ci en a %3 ; choisissez le profil de la caméra dont elle vient</translation>
    </message>
    <message>
        <source>there is no table of temperatures: lines of %1 numbers or more, of one length, up to the end of the file</source>
        <translation>il n’y a pas de tableau de températures : des lignes d’au moins %1 nombres, de même longueur, jusqu’à la fin du fichier</translation>
    </message>
    <message>
        <source>line %1 has %2 values, the table&apos;s first line has %3; export the picture again</source>
        <translation>la ligne %1 a %2 valeurs, la première ligne du tableau en a %3 ; exportez l’image de nouveau</translation>
    </message>
    <message>
        <source>line %1, value %2: &quot;%3&quot; is no temperature in degrees Celsius; export the picture again, without masks</source>
        <translation>ligne %1, valeur %2 : « %3 » n’est pas une température en degrés Celsius ; exportez l’image de nouveau, sans masques</translation>
    </message>
    <message>
        <source>there are no frames here; their names end in one of %1</source>
        <translation>il n’y a pas d’images ici ; leurs noms finissent par %1</translation>
    </message>
    <message>
        <source>the times of the frames are not known; put %1 beside them, or give the profile a frame_rate_Hz</source>
        <translation>les instants des images ne sont pas connus ; placez %1 à côté, ou donnez au profil un frame_rate_Hz</translation>
    </message>
    <message>
        <source>line %1, &quot;%2&quot;, cannot be used: first file,time_s, then one line for each file of this folder, with growing times</source>
        <translation>la ligne %1, « %2 », est inutilisable : d’abord file,time_s, puis une ligne par fichier de ce dossier, aux instants croissants</translation>
    </message>
    <message>
        <source>it is not in the picture; aim the camera at it</source>
        <translation>il n’est pas dans l’image ; dirigez la caméra vers lui</translation>
    </message>
    <message>
        <source>nearer things hide it: %1 of its pixels are seen, %2 are needed</source>
        <translation>des choses plus proches le cachent : %1 de ses pixels sont vus, il en faut %2</translation>
    </message>
    <message>
        <source>it is seen edge-on, at %1 degrees to its face; move the camera</source>
        <translation>il est vu par la tranche, à %1 degrés de sa face ; déplacez la caméra</translation>
    </message>
    <message>
        <source>%1 pixels inside of its edges are too few, %2 are needed; bring the camera nearer</source>
        <translation>%1 pixels à l’intérieur de ses bords ne suffisent pas, il en faut %2 ; rapprochez la caméra</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels tell nothing; check the camera</source>
        <translation>%1 de ses %2 pixels n’indiquent rien ; vérifiez la caméra</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels are outside of what the camera can tell (saturated); take a lower gain</source>
        <translation>%1 de ses %2 pixels sont hors de ce que la caméra peut indiquer (saturés) ; prenez un gain plus faible</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each region its own</source>
        <translation>le nom « %1 » sert deux fois ; donnez à chaque région le sien</translation>
    </message>
    <message>
        <source>what the camera saw, %1, is explained by no temperature of the face at emittance %2 with these reflections; check emittance, view factors and the source&apos;s temperature</source>
        <translation>ce que la caméra a vu, %1, ne s’explique par aucune température de la face à l’émissivité %2 avec ces réflexions ; vérifiez l’émissivité, les facteurs de forme et la température de la source</translation>
    </message>
    <message>
        <source>at emittance %1 the camera tells this face&apos;s temperature to +-%2 only, and a thermometer needs +-%3; paint the face black, or use a contact sensor</source>
        <translation>à l’émissivité %1, la caméra n’indique la température de cette face qu’à ±%2 près, et un thermomètre demande ±%3 ; peignez la face en noir, ou prenez un capteur de contact</translation>
    </message>
    <message>
        <source>the objects&apos; outlines are seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>les contours des objets se voient à %1 poses du robot ; il en faut au moins %2</translation>
    </message>
    <message>
        <source>no object lies in the picture where the camera is said to be; check that pose, or aim the camera at the objects</source>
        <translation>aucun objet n’est dans l’image à la place indiquée de la caméra ; vérifiez cette pose, ou dirigez la caméra vers les objets</translation>
    </message>
    <message>
        <source>the objects do not stand out against what is behind them by %1 or more; make them 5 K or more warmer or colder than the room</source>
        <translation>les objets ne se détachent pas de ce qui est derrière eux de %1 ou plus ; rendez-les plus chauds ou plus froids que la pièce de 5 K au moins</translation>
    </message>
    <message>
        <source>no pose of the camera explains the pictures: at the best one %1 % of the visible outlines are found; check the start pose, the robot&apos;s pose of each picture, the mountings and that no outline is mirrored</source>
        <translation>aucune pose de la caméra n’explique les images : à la meilleure, %1 % des contours visibles sont trouvés ; vérifiez la pose de départ, la pose du robot de chaque image, les montages et qu’aucun contour n’est en miroir</translation>
    </message>
    <message>
        <source>the pictures allow two poses of the camera, %1 degrees apart; take more pictures, with the objects tilted and nearer</source>
        <translation>les images permettent deux poses de la caméra, à %1 degrés l’une de l’autre ; prenez d’autres images, avec les objets inclinés et plus près</translation>
    </message>
    <message>
        <source>picture %1 was left out: %2 points of the objects&apos; outlines are seen in it, %3 are needed</source>
        <translation>l’image %1 a été écartée : on y voit %2 points des contours des objets, il en faut %3</translation>
    </message>
    <message>
        <source>%1 poses of the robot hardly show the robot&apos;s own errors; take %2 or more</source>
        <translation>%1 poses du robot ne montrent guère les écarts propres du robot ; prenez-en %2 ou plus</translation>
    </message>
    <message>
        <source>the robot stood at places in one line, within %1 mm; move it in two directions or more</source>
        <translation>le robot s’est tenu sur une seule ligne, à %1 mm près ; déplacez-le dans deux directions ou plus</translation>
    </message>
    <message>
        <source>all outlines lie at nearly one distance from the camera (within %1 %), where its distance and its tilt are told badly; move the robot towards the camera, too</source>
        <translation>tous les contours sont à presque une même distance de la caméra (à %1 % près), ce qui indique mal sa distance et son inclinaison ; déplacez le robot aussi vers la caméra</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm at the objects, %2 mm across the line of sight (2 sigma)</source>
        <translation>la pose de la caméra est bonne à %1 mm près aux objets, %2 mm en travers de la ligne de visée (2 sigma)</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm only at the objects, %2 mm across the line of sight (2 sigma); take more pictures, with the objects nearer and all over the picture</source>
        <translation>la pose de la caméra n’est bonne qu’à %1 mm près aux objets, %2 mm en travers de la ligne de visée (2 sigma) ; prenez d’autres images, avec les objets plus près et partout dans l’image</translation>
    </message>
    <message>
        <source>%1 pixels show the source&apos;s face and nothing else, %2 are needed; move the objects aside, or bring the camera nearer</source>
        <translation>%1 pixels montrent la face de la source et rien d’autre, il en faut %2 ; écartez les objets, ou rapprochez la caméra</translation>
    </message>
    <message>
        <source>of the ring from %1 to %2 mm too little is seen; it is left out of the profile</source>
        <translation>de l’anneau de %1 à %2 mm on voit trop peu ; il est laissé hors du profil</translation>
    </message>
    <message>
        <source>%1 and %2 overlap; move one of them</source>
        <translation>%1 et %2 se chevauchent ; déplacez l’un des deux</translation>
    </message>
    <message>
        <source>%1 reaches %2 cm from the end-effector&apos;s centre; the robot can carry objects within %3 cm</source>
        <translation>%1 s’étend à %2 cm du centre de l’effecteur ; le robot peut porter des objets jusqu’à %3 cm</translation>
    </message>
    <message>
        <source>%1, %2 and %3 lie in a line; like temperatures for all three cannot be held together, a triangle is better</source>
        <translation>%1, %2 et %3 sont alignés ; des températures proches ne peuvent être tenues pour les trois à la fois, un triangle convient mieux</translation>
    </message>
    <message>
        <source>none of the free axes changes the view factor of %1; mount it elsewhere or free another axis</source>
        <translation>aucun des axes libres ne change le facteur de forme de %1 ; montez-le ailleurs ou libérez un autre axe</translation>
    </message>
    <message>
        <source>%1 and %2 have the same view factor wherever the free axes bring them, so one cannot be heated without the other; mount one elsewhere or free another axis</source>
        <translation>%1 et %2 ont le même facteur de forme partout où les axes libres les amènent : l’un ne peut être chauffé sans l’autre ; montez l’un d’eux ailleurs ou libérez un autre axe</translation>
    </message>
    <message>
        <source>the free axes cannot change the view factors of %1 independently of one another; mount one elsewhere or free another axis</source>
        <translation>les axes libres ne peuvent changer les facteurs de forme de %1 indépendamment les uns des autres ; montez l’un d’eux ailleurs ou libérez un autre axe</translation>
    </message>
    <message>
        <source>as many objects as free axes (%1): their heating decides every movement, none is left for keeping away from limits</source>
        <translation>autant d’objets que d’axes libres (%1) : leur chauffage décide de tout mouvement, il n’en reste aucun pour s’écarter des limites</translation>
    </message>
    <message>
        <source>At rest the sensors&apos; readings lie %1 from their mean; at most %2 can be zeroed. Check the sensors and their noise.</source>
        <translation>Au repos, les mesures des capteurs s’écartent de %1 de leur moyenne ; le zéro n’en corrige que %2 au plus. Vérifiez les capteurs et leur bruit.</translation>
    </message>
    <message>
        <source>there is no such file; check the path</source>
        <translation>ce fichier n’existe pas&#xa0;; vérifiez le chemin</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>le fichier ne peut pas être lu&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>le fichier ne peut pas être écrit&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file has %1, more than the %2 that are read</source>
        <translation>le fichier contient&#xa0;%1, plus que les&#xa0;%2 qui peuvent être lus</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; known here: %2</source>
        <translation>clé «&#xa0;%1&#xa0;» inconnue&#xa0;; clés connues ici&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>la clé «&#xa0;%1&#xa0;» manque</translation>
    </message>
    <message>
        <source>%1 expected, %2 found</source>
        <translation>%1 attendu,&#xa0;%2 trouvé</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is given twice</source>
        <translation>la clé «&#xa0;%1&#xa0;» figure deux fois</translation>
    </message>
    <message>
        <source>nested more than %1 levels deep</source>
        <translation>imbriqué sur plus de&#xa0;%1 niveaux</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; say the same thing; give one of them</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» disent la même chose&#xa0;; n’en donnez qu’un</translation>
    </message>
    <message>
        <source>%1 is out of range; allowed: %2 to %3 %4</source>
        <translation>%1 est hors limites&#xa0;; admis&#xa0;: de&#xa0;%2 à&#xa0;%3&#xa0;%4</translation>
    </message>
    <message>
        <source>%1 is not allowed; it must be greater than zero</source>
        <translation>%1 n’est pas admis&#xa0;; il faut une valeur supérieure à zéro</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; known: %2</source>
        <translation>«&#xa0;%1&#xa0;» est inconnu&#xa0;; connus&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>made by a newer version of Bask (format %1, this one knows up to %2); update Bask to open it</source>
        <translation>créé par une version plus récente de Bask (format&#xa0;%1, celle-ci connaît jusqu’au&#xa0;%2)&#xa0;; mettez Bask à jour pour l’ouvrir</translation>
    </message>
    <message>
        <source>not a regular file; choose another name</source>
        <translation>ce n’est pas un fichier ordinaire ; choisissez un autre nom</translation>
    </message>
    <message>
        <source>this file is also an input; choose another name for the output</source>
        <translation>ce fichier est aussi une entrée ; choisissez un autre nom pour la sortie</translation>
    </message>
    <message>
        <source>another output goes there; give each its own name</source>
        <translation>une autre sortie y va déjà ; donnez à chacune son propre nom</translation>
    </message>
    <message>
        <source>a file of that name exists and is not %1; choose another name</source>
        <translation>un fichier de ce nom existe et n’est pas %1 ; choisissez un autre nom</translation>
    </message>
    <message>
        <source>a file of that name exists and is not an earlier export; choose another folder</source>
        <translation>un fichier de ce nom existe et n’est pas un export antérieur ; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>%1 objects, but the robot has only %2 free degrees of freedom; remove objects or free more axes</source>
        <translation>%1 objets, mais le robot n’a que&#xa0;%2 degrés de liberté libres&#xa0;; retirez des objets ou libérez des axes</translation>
    </message>
    <message>
        <source>there is no object; add at least one</source>
        <translation>il n’y a aucun objet&#xa0;; ajoutez-en au moins un</translation>
    </message>
    <message>
        <source>control characters, invisible ones (of no width, or that turn the direction of writing) and spaces at either end are not allowed here</source>
        <translation>les caractères de contrôle, les caractères invisibles (sans largeur, ou qui changent le sens d’écriture) et les espaces aux extrémités ne sont pas admis ici</translation>
    </message>
    <message>
        <source>the axis &quot;%1&quot; is given twice</source>
        <translation>l’axe « %1 » est donné deux fois</translation>
    </message>
    <message>
        <source>%1 targets given for %2 objects</source>
        <translation>%1 consignes données pour&#xa0;%2 objets</translation>
    </message>
    <message>
        <source>the start&apos;s %1 is %2, outside the workspace of %3 to %4</source>
        <translation>la coordonnée&#xa0;%1 du départ vaut&#xa0;%2, hors de l’espace de travail de&#xa0;%3 à&#xa0;%4</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed</source>
        <translation>au départ, «&#xa0;%1&#xa0;» est à&#xa0;%2 mm du plan de la source&#xa0;; il faut au moins&#xa0;%3 mm</translation>
    </message>
    <message>
        <source>the times must grow, but %1 s comes after %2 s</source>
        <translation>les temps doivent croître, mais %1 s vient après %2 s</translation>
    </message>
    <message>
        <source>no pose of the workspace keeps the clearance to the source; widen the workspace or lower the clearance</source>
        <translation>aucune pose de l’espace de travail ne respecte la distance à la source&#xa0;; élargissez l’espace de travail ou réduisez cette distance</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: with this source it settles at %3 at most, even at a view factor of 1</source>
        <translation>«&#xa0;%1&#xa0;» ne peut être tenu à %2&#xa0;: avec cette source il se stabilise à %3 au plus, même avec un facteur de forme de 1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: it settles at %3 where it does not see the source</source>
        <translation>«&#xa0;%1&#xa0;» ne peut être tenu à %2&#xa0;: il se stabilise à %3 là où il ne voit pas la source</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at most %3</source>
        <translation>«&#xa0;%1&#xa0;» demande un facteur de forme de %2&#xa0;; dans l’espace de travail il a au plus %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at least %3</source>
        <translation>«&#xa0;%1&#xa0;» demande un facteur de forme de %2&#xa0;; dans l’espace de travail il a au moins %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace at most %4 are possible</source>
        <translation>«&#xa0;%1&#xa0;» doit être plus chaud que «&#xa0;%2&#xa0;» de %3&#xa0;; avec ce montage et cet espace de travail, au plus %4 sont possibles</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace it is at least %4 hotter everywhere</source>
        <translation>«&#xa0;%1&#xa0;» doit être plus chaud que «&#xa0;%2&#xa0;» de %3&#xa0;; avec ce montage et cet espace de travail, l’écart est d’au moins %4</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: where they come nearest within the workspace, the target surfaces miss one another by %3 cm, and &quot;%1&quot; is %2 off</source>
        <translation>chaque consigne peut être tenue seule, mais pas toutes ensemble&#xa0;: là où elles sont le plus proches dans l’espace de travail, les surfaces de consigne se manquent de %3&#xa0;cm, et «&#xa0;%1&#xa0;» est à %2 de sa consigne</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: the best pose leaves &quot;%1&quot; %2 off</source>
        <translation>chaque consigne peut être tenue seule, mais pas toutes ensemble&#xa0;: la meilleure pose laisse «&#xa0;%1&#xa0;» à %2 de sa consigne</translation>
    </message>
    <message>
        <source>the motion must begin at source.pose, where %1 is %3, not %2</source>
        <translation>le mouvement doit commencer à source.pose, où %1 vaut %3 et non %2</translation>
    </message>
    <message>
        <source>the lower limit %1 must be less than the upper limit %2</source>
        <translation>la limite inférieure&#xa0;%1 doit être plus petite que la limite supérieure&#xa0;%2</translation>
    </message>
    <message>
        <source>no axis of the robot is free; free at least one</source>
        <translation>aucun axe du robot n’est libre&#xa0;; libérez-en au moins un</translation>
    </message>
    <message>
        <source>this source cannot heat: its net power is %1 W/m2; raise its temperature or emittance, or use the gray source model</source>
        <translation>cette source ne peut pas chauffer&#xa0;: sa puissance nette est de&#xa0;%1 W/m2&#xa0;; augmentez sa température ou son émissivité, ou utilisez le modèle de source grise</translation>
    </message>
    <message>
        <source>only %1 points; an outline needs at least %2</source>
        <translation>%1 points seulement&#xa0;; un contour en demande au moins&#xa0;%2</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a finite number</source>
        <translation>%1 a une coordonnée qui n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in line %2 is not a number</source>
        <translation>«&#xa0;%1&#xa0;» à la ligne&#xa0;%2 n’est pas un nombre</translation>
    </message>
    <message>
        <source>line %1 has %2 column(s); an x and a y are needed</source>
        <translation>la ligne&#xa0;%1 a&#xa0;%2 colonne(s)&#xa0;; il faut un x et un y</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart (at most %2 mm)</source>
        <translation>le contour est ouvert&#xa0;: ses extrémités sont distantes de&#xa0;%1 mm (%2 mm au plus)</translation>
    </message>
    <message>
        <source>the outline crosses itself: edges %1 and %2 meet near (%3, %4) mm</source>
        <translation>le contour se recoupe&#xa0;: les arêtes&#xa0;%1 et&#xa0;%2 se rencontrent près de (%3,&#xa0;%4) mm</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>le contour n’entoure aucune surface</translation>
    </message>
    <message>
        <source>the unit of length is not known; give it (mm, cm, m or in)</source>
        <translation>l’unité de longueur n’est pas connue&#xa0;; indiquez-la (mm, cm, m ou in)</translation>
    </message>
    <message>
        <source>the file holds no outline</source>
        <translation>le fichier ne contient aucun contour</translation>
    </message>
    <message>
        <source>not readable as XML near line %2: %1</source>
        <translation>illisible comme XML vers la ligne %2 : %1</translation>
    </message>
    <message>
        <source>elements are nested or used more than %1 levels deep</source>
        <translation>les éléments sont imbriqués ou réutilisés sur plus de %1 niveaux</translation>
    </message>
    <message>
        <source>not an SVG drawing</source>
        <translation>n’est pas un dessin SVG</translation>
    </message>
    <message>
        <source>line %1: the path data of the drawing are damaged from &quot;%2&quot; on</source>
        <translation>ligne&#xa0;%1&#xa0;: les données de tracé du dessin sont endommagées à partir de «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which holds it</source>
        <translation>ligne&#xa0;%1&#xa0;: &lt;use&gt; dessine «&#xa0;%2&#xa0;», qui le contient</translation>
    </message>
    <message>
        <source>the drawing&apos;s size &quot;%1&quot; cannot be used</source>
        <translation>la taille du dessin « %1 » est inutilisable</translation>
    </message>
    <message>
        <source>the drawing gives its size in pixels, taken as 1/96 inch (0.2646 mm) each; check its size</source>
        <translation>le dessin donne sa taille en pixels, comptés pour 1/96 de pouce (0,2646 mm) chacun ; vérifiez sa taille</translation>
    </message>
    <message>
        <source>left out, since they are no outlines: %1</source>
        <translation>laissés de côté, car ce ne sont pas des contours : %1</translation>
    </message>
    <message>
        <source>the drawing holds more than can be read; save the one outline that is needed</source>
        <translation>le dessin contient plus que ce qui peut être lu ; enregistrez seulement le contour voulu</translation>
    </message>
    <message>
        <source>the drawing reaches farther than %1 m; check its unit</source>
        <translation>le dessin s’étend au-delà de %1 m ; vérifiez son unité</translation>
    </message>
    <message>
        <source>a path has more than the %1 parts that can be read; simplify it, or save the outline as DXF or CSV</source>
        <translation>un tracé a plus que les %1 éléments qui peuvent être lus ; simplifiez-le, ou enregistrez le contour en DXF ou CSV</translation>
    </message>
    <message>
        <source>no silhouette found; the picture needs one dark object on a light ground or the reverse</source>
        <translation>aucune silhouette trouvée&#xa0;; l’image doit montrer un objet sombre sur fond clair, ou l’inverse</translation>
    </message>
    <message>
        <source>the silhouette touches the picture&apos;s border; take the picture with a margin all round</source>
        <translation>la silhouette touche le bord de l’image&#xa0;; refaites la photo avec une marge tout autour</translation>
    </message>
    <message>
        <source>not a picture that can be read, or a damaged one</source>
        <translation>ce n’est pas une image lisible, ou elle est endommagée</translation>
    </message>
    <message>
        <source>the scale is %1 pixels per mm; it must be greater than zero</source>
        <translation>l’échelle est de&#xa0;%1 pixels par mm&#xa0;; elle doit être supérieure à zéro</translation>
    </message>
    <message>
        <source>the scale of the picture is not known; give it in pixels per mm</source>
        <translation>l’échelle de l’image n’est pas connue&#xa0;; indiquez-la en pixels par mm</translation>
    </message>
    <message>
        <source>%1 harmonics; between %2 and %3 can be used</source>
        <translation>%1 harmoniques&#xa0;; on peut en utiliser de&#xa0;%2 à&#xa0;%3</translation>
    </message>
    <message>
        <source>files of type &quot;%1&quot; are not read; known: %2</source>
        <translation>les fichiers de type «&#xa0;%1&#xa0;» ne sont pas lus&#xa0;; connus&#xa0;:&#xa0;%2</translation>
    </message>
    <message>
        <source>there is no outline %1; they are numbered from 0 to %2</source>
        <translation>il n’y a pas de contour %1&#xa0;; ils sont numérotés de 0 à %2</translation>
    </message>
    <message>
        <source>the file holds %1 outlines; the largest is taken</source>
        <translation>le fichier contient %1 contours&#xa0;; le plus grand est retenu</translation>
    </message>
    <message>
        <source>holes left out, since they cross or touch something or are more than %2: %1</source>
        <translation>trous laissés de côté car ils croisent ou touchent quelque chose, ou sont plus de %2&#xa0;: %1</translation>
    </message>
    <message>
        <source>the corners of the holes were thinned from %1 to %2, within %3 mm</source>
        <translation>les sommets des trous ont été réduits de %1 à %2, à %3 mm près</translation>
    </message>
    <message>
        <source>the fitted contour cuts a hole; use more harmonics</source>
        <translation>le contour ajusté coupe un trou&#xa0;; prenez plus d’harmoniques</translation>
    </message>
    <message>
        <source>%1 holes; there may be %2 at most</source>
        <translation>%1 trous&#xa0;; il peut y en avoir %2 au plus</translation>
    </message>
    <message>
        <source>the hole does not lie wholly inside the outline</source>
        <translation>le trou n’est pas entièrement à l’intérieur du contour</translation>
    </message>
    <message>
        <source>the hole meets hole %1 or lies in it, or round it</source>
        <translation>le trou touche le trou %1, se trouve dedans ou l’entoure</translation>
    </message>
    <message>
        <source>silhouettes left out since they touch the picture&apos;s border: %1</source>
        <translation>silhouettes laissées de côté car elles touchent le bord de l’image&#xa0;: %1</translation>
    </message>
    <message>
        <source>more than one scale is given; give pixels per mm, a known length or a marker</source>
        <translation>plusieurs échelles sont indiquées&#xa0;; indiquez des pixels par mm, une longueur connue ou un marqueur</translation>
    </message>
    <message>
        <source>no marker of dictionary %1 is seen; it needs to lie flat in the picture with a light margin</source>
        <translation>aucun marqueur du dictionnaire %1 n’est visible&#xa0;; il doit être à plat dans l’image avec une marge claire</translation>
    </message>
    <message>
        <source>%1 markers are seen; marker %2, the largest, gives the scale</source>
        <translation>%1 marqueurs sont visibles&#xa0;; le marqueur %2, le plus grand, donne l’échelle</translation>
    </message>
    <message>
        <source>the marker is only %1 pixels wide; the scale is uncertain below %2</source>
        <translation>le marqueur n’a que %1 pixels de large&#xa0;; l’échelle est incertaine au-dessous de %2</translation>
    </message>
    <message>
        <source>the outline reaches the horizon of the marker&apos;s plane; look at it more from above</source>
        <translation>le contour atteint l’horizon du plan du marqueur&#xa0;; regardez-le davantage d’en haut</translation>
    </message>
    <message>
        <source>the fitted contour crosses itself; use more harmonics</source>
        <translation>le contour ajusté se croise lui-même&#xa0;; utilisez plus d’harmoniques</translation>
    </message>
    <message>
        <source>the outline cannot be fitted to %1 mm without crossing itself: with %2 harmonics %3 mm are left</source>
        <translation>le contour ne peut être ajusté à %1 mm sans se croiser&#xa0;: avec %2 harmoniques, il reste %3 mm</translation>
    </message>
    <message>
        <source>binary DXF is not read; save the drawing as ASCII DXF</source>
        <translation>le DXF binaire n’est pas lu ; enregistrez le dessin en DXF ASCII</translation>
    </message>
    <message>
        <source>the drawing is cut off: its end mark (EOF) is missing</source>
        <translation>le dessin est tronqué : sa marque de fin (EOF) manque</translation>
    </message>
    <message>
        <source>the drawing is damaged: what line %1 says cannot be</source>
        <translation>le dessin est endommagé : ce que dit la ligne %1 est impossible</translation>
    </message>
    <message>
        <source>block &quot;%1&quot; contains itself</source>
        <translation>le bloc « %1 » se contient lui-même</translation>
    </message>
    <message>
        <source>the drawing names no known unit of length; it is taken as millimetres</source>
        <translation>le dessin n’indique aucune unité de longueur connue ; il est pris en millimètres</translation>
    </message>
    <message>
        <source>%1 hidden entities were left out (layer off or frozen, invisible, or on paper)</source>
        <translation>%1 entités masquées ont été omises (calque désactivé ou gelé, invisible, ou dans l’espace papier)</translation>
    </message>
    <message>
        <source>the outline crosses itself so far that it does not go round %1 % of its area exactly once; at most 1 % is taken, use other harmonics</source>
        <translation>le contour se recoupe tant qu’il ne fait pas exactement une fois le tour de %1 % de sa surface ; 1 % au plus est admis, choisissez d’autres harmoniques</translation>
    </message>
    <message>
        <source>%1 samples, more than the %2 that there may be; take larger steps or a smaller range</source>
        <translation>%1 échantillons, plus que les %2 permis ; prenez des pas plus grands ou une plage plus petite</translation>
    </message>
    <message>
        <source>the sampling was cancelled</source>
        <translation>l’échantillonnage a été annulé</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an axis and cannot be held as well</source>
        <translation>« %1 » est un axe et ne peut pas être fixé en même temps</translation>
    </message>
    <message>
        <source>not a Bask session file</source>
        <translation>ce n’est pas un fichier de session Bask</translation>
    </message>
    <message>
        <source>the session file is damaged: %1</source>
        <translation>le fichier de session est endommagé&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>the session file is in use: %1</source>
        <translation>le fichier de session est en cours d’utilisation&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>not a part of a divided study or field</source>
        <translation>ce n’est pas une partie d’une étude ou d’un champ divisés</translation>
    </message>
    <message>
        <source>this shard was begun already; go on with --resume, or choose another folder</source>
        <translation>cette part a déjà été commencée&#xa0;; continuez avec --resume ou choisissez un autre dossier</translation>
    </message>
    <message>
        <source>another process works on this shard; wait for it, or end it</source>
        <translation>un autre processus travaille à cette part&#xa0;; attendez-le ou terminez-le</translation>
    </message>
    <message>
        <source>a part of other work: %1 is %2 here and %3 there</source>
        <translation>une partie d’un autre travail&#xa0;: %1 vaut %2 ici et %3 là</translation>
    </message>
    <message>
        <source>damaged after %1 whole records; run this shard again with --resume, which keeps these</source>
        <translation>endommagée après %1 enregistrements entiers&#xa0;; relancez cette part avec --resume, qui les garde</translation>
    </message>
    <message>
        <source>%1 of %2 cases are not there yet (%3); run these shards with --resume</source>
        <translation>%1 cas sur %2 manquent encore (%3)&#xa0;; lancez ces parts avec --resume</translation>
    </message>
    <message>
        <source>%1 readings in windows long enough are too few: at least %2 windows of %3 s are needed; record a longer run</source>
        <translation>%1 mesures dans des fenêtres assez longues, c’est trop peu : il faut au moins %2 fenêtres de %3 s ; enregistrez un essai plus long</translation>
    </message>
    <message>
        <source>the source was never in view; record a run that heats</source>
        <translation>la source n’a jamais été en vue ; enregistrez un essai qui chauffe</translation>
    </message>
    <message>
        <source>the view factor hardly varied (by %1), so heating and cooling cannot be told apart; record a run that moves</source>
        <translation>le facteur de forme n’a guère varié (de %1), donc l’échauffement et le refroidissement ne se distinguent pas ; enregistrez un essai avec des mouvements</translation>
    </message>
    <message>
        <source>the record tells %1 within %2 % only; at most 25 % can be used; record a run that heats and cools more</source>
        <translation>l’enregistrement ne donne %1 qu’à %2 % près ; au plus 25 % sont utilisables ; enregistrez un essai qui chauffe et refroidit davantage</translation>
    </message>
    <message>
        <source>%1 comes out below zero: the heat balance does not describe this record; check the sensor, the source and the environment&apos;s temperature</source>
        <translation>%1 ressort négatif : le bilan thermique ne décrit pas cet enregistrement ; vérifiez le capteur, la source et la température ambiante</translation>
    </message>
    <message>
        <source>No experiment is loaded. Open one or make a new one.</source>
        <translation>Aucune expérience n’est chargée. Ouvrez-en une ou créez-en une nouvelle.</translation>
    </message>
    <message>
        <source>The objects are not at rest at the room&apos;s temperature (%1), so the sensors cannot be zeroed. Let them cool, or correct the environment&apos;s temperature.</source>
        <translation>Les objets ne sont pas stables à la température ambiante (%1), les capteurs ne peuvent donc pas être ajustés. Laissez-les refroidir ou corrigez la température ambiante.</translation>
    </message>
    <message>
        <source>The workspace lets %1 go to %2, but the robot says that it goes to %3 only. Make the workspace smaller, or correct what the robot says.</source>
        <translation>L’espace de travail laisse&#xa0;%1 aller jusqu’à&#xa0;%2, mais le robot dit n’aller que jusqu’à&#xa0;%3. Réduisez l’espace de travail, ou corrigez ce que dit le robot.</translation>
    </message>
    <message>
        <source>Held by the operator. Resume or stop.</source>
        <translation>Mis en pause par l’opérateur. Reprenez ou arrêtez.</translation>
    </message>
    <message>
        <source>The targets cannot be held. See the Targets page.</source>
        <translation>Les consignes ne peuvent pas être tenues. Voir la page Consignes.</translation>
    </message>
    <message>
        <source>The source&apos;s pose is measured again</source>
        <translation>La pose de la source est de nouveau mesurée</translation>
    </message>
    <message>
        <source>The heat source does not answer: %1. Check its link, then reset.</source>
        <translation>La source de chaleur ne répond pas&#xa0;:&#xa0;%1. Vérifiez sa liaison, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The recording failed: %1. Free disk space or choose another folder, then reset.</source>
        <translation>L’enregistrement a échoué&#xa0;:&#xa0;%1. Libérez de l’espace disque ou choisissez un autre dossier, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The engine met an internal fault: %1. Reset, and report it if it comes again.</source>
        <translation>Le moteur a rencontré un défaut interne&#xa0;:&#xa0;%1. Réinitialisez, et signalez-le s’il revient.</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Démarré</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>Mis en pause</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>Repris</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>STOP pressé</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialisé</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>Tous les objets sont stabilisés</translation>
    </message>
    <message>
        <source>Not settled: %1</source>
        <translation>Non stabilisés&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Targets: %1</source>
        <translation>Consignes : %1</translation>
    </message>
    <message>
        <source>Controller or gains changed</source>
        <translation>Régulateur ou gains modifiés</translation>
    </message>
    <message>
        <source>The thermal camera has looked at its shutter: its drift counts from now</source>
        <translation>La caméra thermique a regardé son obturateur : sa dérive compte à partir de maintenant</translation>
    </message>
    <message>
        <source>Sensors zeroed at ambient</source>
        <translation>Capteurs ajustés à l’ambiante</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is back</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» est de retour</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be done in the state &quot;%2&quot;</source>
        <translation>«&#xa0;%1&#xa0;» est impossible dans l’état «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>A run is on; stop it first</source>
        <translation>Un essai est en cours&#xa0;; arrêtez-le d’abord</translation>
    </message>
    <message>
        <source>no part of the picture is clearly of this colour; set a tolerance or take another colour</source>
        <translation>aucune partie de l’image n’est nettement de cette couleur ; donnez une tolérance ou prenez une autre couleur</translation>
    </message>
    <message>
        <source>the drawing names its unit itself (%1); the unit given is not used</source>
        <translation>le dessin nomme lui-même son unité (%1) ; l’unité donnée n’est pas utilisée</translation>
    </message>
    <message>
        <source>marker %1 is listed twice; each id is one marker</source>
        <translation>le marqueur %1 figure deux fois ; à chaque identifiant un seul marqueur</translation>
    </message>
    <message>
        <source>none of the markers %1 was seen</source>
        <translation>aucun des marqueurs %1 n’a été vu</translation>
    </message>
    <message>
        <source>marker %1 moved by %2 px while it was looked at; camera, source and end-effector must keep still</source>
        <translation>le marqueur %1 s’est déplacé de %2 px pendant la prise de vues ; la caméra, la source et l’effecteur doivent rester immobiles</translation>
    </message>
    <message>
        <source>no pose shows the markers %1 within %2 px of where they are seen; check their ids, sides and places</source>
        <translation>aucune pose ne montre les marqueurs %1 à moins de %2 px de l’endroit où ils sont vus ; vérifiez leurs identifiants, leurs côtés et leurs positions</translation>
    </message>
    <message>
        <source>marker %1 was left out: it is seen %2 px from where the others put it; check its id and place</source>
        <translation>le marqueur %1 a été écarté : il est vu à %2 px de l’endroit que donnent les autres ; vérifiez son identifiant et sa position</translation>
    </message>
    <message>
        <source>marker %1 is %2 mm wide by the others, not %3 mm; measure the print</source>
        <translation>le marqueur %1 mesure %2 mm de côté d’après les autres, et non %3 mm ; mesurez l’impression</translation>
    </message>
    <message>
        <source>the markers are seen %1 px from where they fit best together; the uncertainty is widened accordingly; check their sides and places, and the camera&apos;s calibration</source>
        <translation>les marqueurs sont vus à %1 px de l’endroit où ils s’accordent le mieux ; l’incertitude est élargie en conséquence ; vérifiez leurs côtés et leurs positions, et l’étalonnage de la caméra</translation>
    </message>
    <message>
        <source>the markers&apos; corners allow two poses, %1 degrees apart; use more or larger markers, or tilt them against the camera</source>
        <translation>les coins des marqueurs permettent deux poses, à %1 degrés l’une de l’autre ; utilisez des marqueurs plus nombreux ou plus grands, ou inclinez-les par rapport à la caméra</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees (2 sigma)</source>
        <translation>la pose est sûre à %1 mm et %2 degrés près (2 sigma)</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), and these markers before this camera allow no better than %3 mm and %4 degrees; use more or larger markers farther apart, tilt them against the camera, or bring it nearer</source>
        <translation>la pose n’est sûre qu’à %1 mm et %2 degrés près (2 sigma), et ces marqueurs devant cette caméra ne permettent pas mieux que %3 mm et %4 degrés ; utilisez des marqueurs plus nombreux, plus grands ou plus écartés, inclinez-les par rapport à la caméra ou rapprochez-la</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), though these markers before this camera allow %3 mm and %4 degrees; check light and focus, that all markers are seen, and their places</source>
        <translation>la pose n’est sûre qu’à %1 mm et %2 degrés près (2 sigma), alors que ces marqueurs devant cette caméra permettent %3 mm et %4 degrés ; vérifiez l’éclairage et la mise au point, que tous les marqueurs sont vus, et leurs positions</translation>
    </message>
    <message>
        <source>the end-effector&apos;s markers were seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>les marqueurs de l’effecteur ont été vus à %1 poses du robot ; il en faut au moins %2</translation>
    </message>
    <message>
        <source>the robot hardly turned (by %1 degrees between poses; %2 are needed): without turns the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about two axes, or measure where the markers sit on the end-effector</source>
        <translation>le robot n’a guère tourné (de %1 degrés d’une pose à l’autre ; il en faut %2) : sans rotation, la position de la caméra ne se distingue pas du montage des marqueurs ; faites-le tourner autour de deux axes, ou mesurez où sont les marqueurs sur l’effecteur</translation>
    </message>
    <message>
        <source>the robot turned about one axis only (by %1 degrees about any other; %2 are needed): along that axis the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about a second one, or measure where the markers sit on the end-effector</source>
        <translation>le robot n’a tourné qu’autour d’un seul axe (de %1 degrés autour de tout autre ; il en faut %2) : le long de cet axe, la position de la caméra ne se distingue pas du montage des marqueurs ; faites-le tourner autour d’un second, ou mesurez où sont les marqueurs sur l’effecteur</translation>
    </message>
    <message>
        <source>the robot&apos;s poses and the pictures contradict one another; check that each picture was taken at its pose, that the camera kept still, and the markers&apos; sides and places</source>
        <translation>les poses du robot et les images se contredisent ; vérifiez que chaque image a été prise à sa pose, que la caméra est restée immobile, ainsi que les côtés et les positions des marqueurs</translation>
    </message>
    <message>
        <source>pose %1 of the robot was left out: the markers are seen %2 mm and %3 degrees from where the robot has them</source>
        <translation>la pose %1 du robot a été écartée : les marqueurs sont vus à %2 mm et %3 degrés de l’endroit où le robot les place</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; is being opened</source>
        <translation>la caméra « %1 » est en cours d’ouverture</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; cannot be opened (%2); a camera is a number, a device, a video file, a folder of pictures or an address such as rtsp://host/stream</source>
        <translation>impossible d’ouvrir la caméra « %1 » (%2) ; une caméra est un numéro, un périphérique, un fichier vidéo, un dossier d’images ou une adresse telle que rtsp://hôte/flux</translation>
    </message>
    <message>
        <source>no picture from camera &quot;%1&quot; for a second (%2); check cable and power. It is taken up again as soon as it answers</source>
        <translation>aucune image de la caméra « %1 » depuis une seconde (%2) ; vérifiez le câble et l’alimentation. Elle est reprise dès qu’elle répond</translation>
    </message>
    <message>
        <source>the source has markers and is followed by the camera, which is not calibrated yet: calibrate the camera and measure where it stands on the Calibrate page, or leave the source untracked</source>
        <translation>la source porte des marqueurs et est suivie par la caméra, qui n’est pas encore étalonnée : étalonnez la caméra et mesurez sa place sur la page Étalonner, ou ne suivez pas la source</translation>
    </message>
    <message>
        <source>the robot cannot go there: outside of its workspace, or too near to the source</source>
        <translation>le robot ne peut pas y aller : hors de son espace de travail, ou trop près de la source</translation>
    </message>
    <message>
        <source>the calibration was cancelled</source>
        <translation>l’étalonnage a été annulé</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it</source>
        <translation>les erreurs à %3 m sont de %1 mm en travers de la ligne de visée et de %2 mm le long de celle-ci</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; check that the board is flat, measured and sharp in the pictures, and leave out views that stand out</source>
        <translation>les erreurs à %3 m sont de %1 mm en travers de la ligne de visée et de %2 mm le long de celle-ci ; vérifiez que la mire est plane, mesurée et nette sur les images, et écartez les vues qui se distinguent</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; take more views with the board tilted, near the camera and at the picture&apos;s edges</source>
        <translation>les erreurs à %3 m sont de %1 mm en travers de la ligne de visée et de %2 mm le long de celle-ci ; prenez davantage de vues avec la mire inclinée, près de la caméra et aux bords de l’image</translation>
    </message>
    <message>
        <source>%1 views cannot be checked against one another; take at least %2</source>
        <translation>%1 vues ne se laissent pas vérifier les unes par les autres ; prenez-en au moins %2</translation>
    </message>
    <message>
        <source>bring the board to the left edge of the picture</source>
        <translation>amenez la mire au bord gauche de l’image</translation>
    </message>
    <message>
        <source>bring the board to the right edge of the picture</source>
        <translation>amenez la mire au bord droit de l’image</translation>
    </message>
    <message>
        <source>bring the board to the upper edge of the picture</source>
        <translation>amenez la mire au bord supérieur de l’image</translation>
    </message>
    <message>
        <source>bring the board to the lower edge of the picture</source>
        <translation>amenez la mire au bord inférieur de l’image</translation>
    </message>
    <message>
        <source>bring the board nearer to the camera</source>
        <translation>approchez la mire de la caméra</translation>
    </message>
    <message>
        <source>tilt the board more, its left or right edge towards the camera</source>
        <translation>inclinez davantage la mire, son bord gauche ou droit vers la caméra</translation>
    </message>
    <message>
        <source>tilt the board more, its upper or lower edge towards the camera</source>
        <translation>inclinez davantage la mire, son bord supérieur ou inférieur vers la caméra</translation>
    </message>
    <message>
        <source>%1 views of %2 that are enough</source>
        <translation>%1 vues sur les %2 qui suffisent</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened: %2. Check the cable and the name of the port; Bask tries again by itself.</source>
        <translation>« %1 » ne peut pas être ouvert : %2. Vérifiez le câble et le nom du port ; Bask réessaie de lui-même.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists and is not a link; choose another path</source>
        <translation>« %1 » existe et n’est pas un lien ; choisissez un autre chemin</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its trip limit of %3. The robot takes it away and the heat is off. Check the object and its sensor. Reset when it has cooled.</source>
        <translation>«&#xa0;%1&#xa0;» est à %2, au-dessus de sa limite de déclenchement de %3. Le robot l’éloigne et le chauffage est coupé. Vérifiez l’objet et son capteur. Réinitialisez quand il a refroidi.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis; axes are X, Y, Z, A, B, C and R</source>
        <translation>« %1 » n’est pas un axe ; les axes sont X, Y, Z, A, B, C et R</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes no more bytes: the device does not read. Check its power and the flow control of the port.</source>
        <translation>« %1 » ne prend plus d’octets : l’appareil ne lit pas. Vérifiez son alimentation et le contrôle de flux du port.</translation>
    </message>
    <message>
        <source>%1 channels for %2 objects; give each object one</source>
        <translation>%1 voies pour %2 objets ; donnez-en une à chaque objet</translation>
    </message>
    <message>
        <source>%1 is free, but no axis of the robot drives it</source>
        <translation>%1 est libre, mais aucun axe du robot ne l’entraîne</translation>
    </message>
    <message>
        <source>Bask has just connected to the rig. Check it, then reset.</source>
        <translation>Bask vient de se connecter au banc. Vérifiez-le, puis réinitialisez.</translation>
    </message>
    <message>
        <source>Only %1 MB of disk space are left; a recording needs %2 MB. Free some space, then arm again.</source>
        <translation>Il ne reste que %1 Mo sur le disque ; un enregistrement en demande %2 Mo. Libérez de la place, puis armez de nouveau.</translation>
    </message>
    <message>
        <source>The robot is held at its own panel (%1). Release it there, then clear the alarm.</source>
        <translation>Le robot est retenu à son propre panneau (%1). Libérez-le là, puis effacez l’alarme.</translation>
    </message>
    <message>
        <source>The robot is switched off at its own controller. Enable it, then clear the alarm.</source>
        <translation>Le robot est désactivé à son propre contrôleur. Activez-le, puis effacez l’alarme.</translation>
    </message>
    <message>
        <source>The robot reports alarm %1: %2. Remove the cause and clear the alarm. Home the robot if its place is not sure.</source>
        <translation>Le robot signale l’alarme %1&#xa0;: %2. Éliminez la cause et effacez l’alarme. Faites la prise d’origine si sa position n’est pas sûre.</translation>
    </message>
    <message>
        <source>The robot&apos;s controller has restarted: its last order is lost and its place is not sure. Home it, or confirm its place, then reset.</source>
        <translation>Le contrôleur du robot a redémarré : le dernier ordre est perdu et sa position n’est pas sûre. Faites sa prise d’origine, ou confirmez sa position, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The source is at %1, above its trip limit of %2. The robot takes the objects away and the heat is off. Check the source&apos;s controller and sensor. Reset when it has cooled.</source>
        <translation>La source est à %1, au-dessus de sa limite de déclenchement de %2. Le robot éloigne les objets et le chauffage est coupé. Vérifiez le régulateur et le capteur de la source. Réinitialisez quand elle a refroidi.</translation>
    </message>
    <message>
        <source>The source is at %1 and has come no nearer to %2 for %3 s. The heat is off. Check that the source is switched on and that its sensor is in place, then reset.</source>
        <translation>La source est à %1 et ne s’approche plus de %2 depuis %3 s. Le chauffage est coupé. Vérifiez que la source est allumée et que son capteur est en place, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2. Bask switches the heat off. Check its own panel and limits, then reset.</source>
        <translation>La source a été réglée à %1 mais relit %2. Bask coupe le chauffage. Vérifiez son propre panneau et ses limites, puis réinitialisez.</translation>
    </message>
    <message>
        <source>a step of the robot would leave its workspace or come too near to the source; it was not sent</source>
        <translation>un pas du robot sortirait de son espace de travail ou s’approcherait trop de la source ; il n’a pas été envoyé</translation>
    </message>
    <message>
        <source>faults can be simulated on the simulated rig only</source>
        <translation>les défauts ne peuvent être simulés que sur le banc simulé</translation>
    </message>
    <message>
        <source>over: %1</source>
        <translation>terminé : %1</translation>
    </message>
    <message>
        <source>the axis %1 is given twice</source>
        <translation>l’axe %1 est donné deux fois</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; has not answered for %2 s. Check its power, the cable, and the speed and unit set for it.</source>
        <translation>l’appareil sur « %1 » ne répond plus depuis %2 s. Vérifiez son alimentation, le câble, ainsi que la vitesse et l’adresse réglées.</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; is not the one that is set: it says &quot;%2&quot;. Check the port and the driver.</source>
        <translation>l’appareil sur « %1 » n’est pas celui qui est réglé : il dit « %2 ». Vérifiez le port et le pilote.</translation>
    </message>
    <message>
        <source>the experiment has no rig of its own (&quot;rig&quot;), only the simulated one</source>
        <translation>l’expérience n’a pas de banc à elle (« rig »), seulement le banc simulé</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; was lost: %2. Check the cable; Bask opens it again as soon as it is there.</source>
        <translation>la liaison avec « %1 » est perdue : %2. Vérifiez le câble ; Bask la rouvre dès qu’elle revient.</translation>
    </message>
    <message>
        <source>the profile &quot;%1&quot; is that of another kind of device</source>
        <translation>le profil « %1 » est celui d’une autre sorte d’appareil</translation>
    </message>
    <message>
        <source>the rig has no %1; set one, or use the simulated rig</source>
        <translation>il manque au banc : %1 ; configurez cet appareil, ou utilisez le banc simulé</translation>
    </message>
    <message>
        <source>the robot has no axis</source>
        <translation>le robot n’a aucun axe</translation>
    </message>
    <message>
        <source>this robot has no homing</source>
        <translation>ce robot n’a pas de prise d’origine</translation>
    </message>
    <message>
        <source>two axes drive %1</source>
        <translation>deux axes entraînent %1</translation>
    </message>
    <message>
        <source>two devices are on &quot;%1&quot;; only Modbus devices of different units and the same line settings can share a port</source>
        <translation>deux appareils sont sur « %1 » ; seuls des appareils Modbus d’adresses différentes et de mêmes réglages de ligne peuvent partager un port</translation>
    </message>
    <message>
        <source>two objects have channel %1; give each its own</source>
        <translation>deux objets ont la voie %1 ; donnez à chacun la sienne</translation>
    </message>
    <message>
        <source>unit %2 on &quot;%1&quot; refuses the request with exception %3. Check the profile set for it.</source>
        <translation>l’appareil d’adresse %2 sur « %1 » refuse la demande avec l’exception %3. Vérifiez le profil réglé.</translation>
    </message>
    <message>
        <source>The heat source did not obey the order to switch off. Switch it off at its mains. Its answer: %1</source>
        <translation>La source de chaleur n’a pas exécuté l’ordre de s’éteindre. Coupez-la au secteur. Sa réponse&#xa0;: %1</translation>
    </message>
    <message>
        <source>The heat source has reported no temperature for %1 s. The heat is off. Check its sensor and its link, then reset.</source>
        <translation>La source de chaleur n’a donné aucune température depuis %1 s. Le chauffage est coupé. Vérifiez son capteur et sa liaison, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The source is heated manually and is at %1: Bask cannot switch it off. Switch it off yourself, and keep the objects away from it.</source>
        <translation>La source est chauffée manuellement et est à %1&#xa0;: Bask ne peut pas l’éteindre. Éteignez-la vous-même et gardez les objets loin d’elle.</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; should have changed by %2 in %3 s but has not. Its sensor may be off, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check all three, then reset.</source>
        <translation>La température de «&#xa0;%1&#xa0;» aurait dû changer de %2 en %3 s et ne l’a pas fait. Capteur décollé, objet absent, ou source ailleurs que prévu. Bask coupe le chauffage. Vérifiez les trois, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is above its warning limit of %3, where every run holds. Lower the target, or raise the limit if object and sensor bear it.</source>
        <translation>La consigne de « %1 », %2, dépasse sa limite d’avertissement de %3, où tout essai se met en pause. Baissez la consigne, ou relevez la limite si l’objet et le capteur la supportent.</translation>
    </message>
    <message>
        <source>The source is still at %1, %2 s after its heat was switched off. Switch it off at its mains, then reset.</source>
        <translation>La source est encore à %1, %2 s après l’arrêt de son chauffage. Coupez-la au secteur, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The robot refused a line with error %1: %2. Remove the cause, clear the alarm, then reset.</source>
        <translation>Le robot a refusé une ligne, erreur %1&#xa0;: %2. Éliminez la cause, effacez l’alarme, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The robot has not reported its state yet. Wait a moment. If this lasts, check its power, its link and the driver set for it.</source>
        <translation>Le robot n’a pas encore donné son état. Attendez un instant. Si cela dure, vérifiez son alimentation, sa liaison et le pilote réglé.</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; gave an answer that does not fit the question: %2. The answer was not used. Check the settings of the port, and of the device itself.</source>
        <translation>l’appareil sur «&#xa0;%1&#xa0;» a donné une réponse qui ne correspond pas à la question&#xa0;: %2. La réponse n’a pas été utilisée. Vérifiez les réglages du port et ceux de l’appareil.</translation>
    </message>
    <message>
        <source>No pose in the workspace holds all targets together; going to the best compromise found, expected to end at %1 of the targets. The Targets page shows what can be held.</source>
        <translation>Aucune pose de l’espace de travail ne tient toutes les consignes ensemble ; le robot rejoint le meilleur compromis trouvé, attendu à %1 des consignes. La page Consignes montre ce qui peut être tenu.</translation>
    </message>
    <message>
        <source>The heat source was stopped at its own panel or by its own protection; Bask keeps it off. Find the cause, then reset.</source>
        <translation>La source de chaleur a été arrêtée à son propre panneau ou par sa propre protection ; Bask la laisse éteinte. Cherchez-en la cause, puis réinitialisez.</translation>
    </message>
    <message>
        <source>with the profile &quot;%1&quot; the source has no watchdog: it stays hot when Bask or the computer dies. Take a controller that has one, or allow it with &quot;unattended_heat&quot;: true.</source>
        <translation>avec le profil « %1 », la source n’a pas de chien de garde : elle reste chaude si Bask ou l’ordinateur s’arrête. Prenez un régulateur qui en a un, ou autorisez-le par &quot;unattended_heat&quot;: true.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are far from the source but differ by %3, more than %4. One sensor is wrong or off its object. Check both.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» sont loin de la source, mais diffèrent de %3, plus que %4. Un capteur est faux ou décollé de son objet. Vérifiez les deux.</translation>
    </message>
    <message>
        <source>The control loop was delayed by %1 s, more than the allowed %2 s; the robot stood still. Close other programs on this computer.</source>
        <translation>La boucle de commande a été retardée de %1 s, plus que les %2 s admises&#xa0;; le robot est resté immobile. Fermez les autres programmes de cet ordinateur.</translation>
    </message>
    <message>
        <source>The robot is %1 mm from where its steps should have brought it, more than %2 mm. It may have been pushed or have lost steps: check it, home it, then reset.</source>
        <translation>Le robot est à %1 mm de là où ses pas auraient dû l’amener, plus que %2 mm. Il a peut-être été poussé ou a perdu des pas : vérifiez-le, faites sa prise d’origine, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The robot&apos;s place is not sure: Bask has not seen it homed since it connected, or its place was lost in a restart or a stop. Home it, or confirm its place.</source>
        <translation>La position du robot n’est pas sûre&#xa0;: depuis la connexion Bask n’a vu aucune prise d’origine, ou elle a été perdue par un redémarrage ou un arrêt. Faites sa prise d’origine, ou confirmez sa position.</translation>
    </message>
    <message>
        <source>The source warmed by %1 in %2 s although its heat is off; at most %3 is allowed. Its relay may be stuck, or somebody heats it at its own panel. Switch it off at its mains, then reset.</source>
        <translation>La source a chauffé de %1 en %2 s alors que son chauffage est coupé&#xa0;; %3 au plus est admis. Son relais est peut-être collé, ou quelqu’un la chauffe depuis son pupitre. Coupez-la au secteur, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; jumped by %2/s; heat can change it by at most %3/s. Check for a loose contact, and that the sensor is on its object. Bask uses it again when it agrees with the heat, or when a person confirms it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» a sauté de %2/s&#xa0;; la chaleur ne permet que %3/s au plus. Cherchez un faux contact, et vérifiez que le capteur est sur son objet. Bask l’utilise de nouveau quand il s’accorde avec la chaleur, ou quand une personne le confirme.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but after the heat that its object received the object should be at %3 to %4. Check that the sensor is on its object, then confirm it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» indique %2, mais d’après la chaleur reçue, son objet devrait être entre %3 et %4. Vérifiez que le capteur est sur son objet, puis confirmez-le.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s, without its usual noise: it may have stopped. Watch whether it follows the heat, or confirm it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» donne exactement la même valeur depuis %2 s, sans son bruit habituel&#xa0;: il s’est peut-être arrêté. Voyez s’il suit la chaleur, ou confirmez-le.</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; has changed by %2 in %3 s, which no heat or loss explains. Its sensor may be off, or something touches the object. Bask switches the heat off. Check both, then reset.</source>
        <translation>La température de «&#xa0;%1&#xa0;» a changé de %2 en %3 s, ce qu’aucune chaleur ni perte n’explique. Son capteur est peut-être décollé, ou quelque chose touche l’objet. Bask coupe le chauffage. Vérifiez les deux, puis réinitialisez.</translation>
    </message>
    <message>
        <source>Another Bask runs with the same settings. The alarms of this one are kept in %1.</source>
        <translation>Un autre Bask fonctionne avec les mêmes réglages. Les alarmes de celui-ci sont conservées dans %1.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is confirmed at %2</source>
        <translation>Le capteur de « %1 » est confirmé à %2</translation>
    </message>
    <message>
        <source>The heat source has no watchdog: if this computer stops, it stays hot. Do not leave it unattended.</source>
        <translation>La source de chaleur n’a pas de chien de garde&#xa0;: si cet ordinateur s’arrête, elle reste chaude. Ne la laissez pas sans surveillance.</translation>
    </message>
    <message>
        <source>No heat without the guard process, which switches the heater off if Bask dies; it cannot be started: %1. Install Bask again.</source>
        <translation>Pas de chauffage sans le processus de garde, qui coupe le chauffage si Bask meurt ; il ne peut pas démarrer : %1. Réinstallez Bask.</translation>
    </message>
    <message>
        <source>The guard process has taken the heater over and switches it off: %1. Its log says what it did. Find the cause, then reset.</source>
        <translation>Le processus de garde a repris le chauffage et le coupe&#xa0;: %1. Son journal dit ce qu’il a fait. Cherchez-en la cause, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The heater&apos;s guard process has ended; Bask has taken the port back and switches the heat off. Reset starts a new guard.</source>
        <translation>Le processus de garde du chauffage a pris fin ; Bask a repris le port et coupe le chauffage. Réinitialiser en démarre un nouveau.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given nothing new for %2 s. Check its cable.</source>
        <translation>Le capteur de « %1 » n’a rien donné de nouveau depuis %2 s. Vérifiez son câble.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; gives no plausible value: a broken wire, a loose contact, or another device than was set up. Check it.</source>
        <translation>Le capteur de « %1 » ne donne aucune valeur plausible : fil coupé, faux contact, ou un autre appareil que celui configuré. Vérifiez-le.</translation>
    </message>
    <message>
        <source>The source&apos;s pose is not measured any more. Bring the source back into view.</source>
        <translation>La pose de la source n’est plus mesurée. Ramenez la source dans le champ.</translation>
    </message>
    <message>
        <source>Held by the engine: %1</source>
        <translation>Mis en pause par le moteur : %1</translation>
    </message>
    <message>
        <source>Ended by the engine: %1</source>
        <translation>Terminé par le moteur : %1</translation>
    </message>
    <message>
        <source>Retreat: the heat is off, the robot takes the objects away</source>
        <translation>Retrait : chauffage coupé, le robot éloigne les objets</translation>
    </message>
    <message>
        <source>The robot takes the objects away by itself: %1</source>
        <translation>Le robot éloigne les objets de lui-même : %1</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading of &quot;%2&quot;: the run is ended</source>
        <translation>En pause depuis plus de %1 s sans mesure de « %2 » : l’essai prend fin</translation>
    </message>
    <message>
        <source>Held for more than %1 s without the source&apos;s pose: the run is ended</source>
        <translation>En pause depuis plus de %1 s sans la pose de la source : l’essai prend fin</translation>
    </message>
    <message>
        <source>The robot stops</source>
        <translation>Le robot s’arrête</translation>
    </message>
    <message>
        <source>The run ends, with a retreat and the heat off</source>
        <translation>L’essai prend fin, avec retrait et chauffage coupé</translation>
    </message>
    <message>
        <source>The heat is switched off</source>
        <translation>Le chauffage est coupé</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source</source>
        <translation>Le robot éloigne les objets de la source</translation>
    </message>
    <message>
        <source>Reset when the rig is safe.</source>
        <translation>Réinitialisez quand le banc est sûr.</translation>
    </message>
    <message>
        <source>Reset is possible when this is over: %1</source>
        <translation>Réinitialiser sera possible quand ceci sera passé : %1</translation>
    </message>
    <message>
        <source>Keep your hands off the robot and press Retreat: it takes the objects away from the heat.</source>
        <translation>N’approchez pas les mains du robot et pressez Retrait : il éloigne les objets de la chaleur.</translation>
    </message>
    <message>
        <source>Resume, or stop the run.</source>
        <translation>Reprenez, ou arrêtez l’essai.</translation>
    </message>
    <message>
        <source>Resume is possible when this is over; Stop ends the run: %1</source>
        <translation>Reprendre sera possible quand ceci sera passé ; Arrêter termine l’essai : %1</translation>
    </message>
    <message>
        <source>an alarm is shelved with a reason; say why</source>
        <translation>une alarme se met de côté avec une raison ; dites pourquoi</translation>
    </message>
    <message>
        <source>%1: %3 instead of %2</source>
        <translation>%1 : %3 au lieu de %2</translation>
    </message>
    <message>
        <source>this allows the real rig more than before: %1. Whether robot, source, objects and sensors bear it is for a person to say</source>
        <translation>le banc réel pourra aller plus loin qu’avant : %1. C’est à une personne de dire si robot, source, objets et capteurs le supportent</translation>
    </message>
    <message>
        <source>The robot was ordered to take the objects away but does not move; %1 cm are left. The heat is off. Take the objects away by hand; they may be hot. Check the robot&apos;s power and its drives.</source>
        <translation>Le robot doit éloigner les objets mais ne bouge pas&#xa0;; il reste %1 cm. Le chauffage est coupé. Éloignez les objets à la main&#xa0;; ils peuvent être très chauds. Vérifiez l’alimentation du robot et ses moteurs.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its warning limit of %3. Let it cool: Stop or Retreat takes it away. Check its target and its limits.</source>
        <translation>« %1 » est à %2, au-dessus de sa limite d’avertissement de %3. Laissez-le refroidir : Arrêter ou Retrait l’éloigne. Vérifiez sa consigne et ses limites.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is open: a wire or the plug is off. Repair it.</source>
        <translation>Le capteur de « %1 » est ouvert : un fil ou la fiche est débranché. Réparez-le.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is shorted. Check its wires and its plug, and repair it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» est en court-circuit. Vérifiez ses fils et sa fiche, et réparez-le.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s: the sensor or its device has stopped. Check both.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» donne exactement la même valeur depuis %2 s&#xa0;: le capteur ou son appareil s’est arrêté. Vérifiez les deux.</translation>
    </message>
    <message>
        <source>The heat source reports %1, more than %3 below the room&apos;s %2. It may use another unit (°C, °F) than its profile says, or its sensor is wrong. It is not heated. Set both to the same unit, then reset.</source>
        <translation>La source de chaleur indique %1, plus de %3 au-dessous des %2 de la pièce. Elle utilise peut-être une autre unité (°C, °F) que ne le dit son profil, ou son capteur est faux. Elle n’est pas chauffée. Réglez les deux sur la même unité, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The heat source reports %1 °C instead of %2 °C. This is the same number in °F: it uses another unit than its profile says. It is not heated. Set both to the same unit, then reset.</source>
        <translation>La source de chaleur indique %1 °C au lieu de %2 °C. C’est le même nombre en °F&#xa0;: elle utilise une autre unité que ne le dit son profil. Elle n’est pas chauffée. Réglez les deux sur la même unité, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s while the source was hot or the robot moved. What happened meanwhile is not known. The heat is off. Check the rig, then reset.</source>
        <translation>L’ordinateur a été en veille pendant %1 s alors que la source était chaude ou que le robot bougeait. Ce qui s’est passé entre-temps n’est pas connu. Le chauffage est coupé. Vérifiez le banc, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s</source>
        <translation>L’ordinateur a été en veille pendant %1 s</translation>
    </message>
    <message>
        <source>This computer cannot be kept awake while heat is on (%1): switch off its standby, and keep its lid open</source>
        <translation>Cet ordinateur ne peut pas être gardé éveillé pendant le chauffage (%1) : désactivez sa mise en veille et gardez son capot ouvert</translation>
    </message>
    <message>
        <source>The device that answers at %1 is the right one from now on</source>
        <translation>L’appareil qui répond sur %1 est dorénavant le bon</translation>
    </message>
    <message>
        <source>Another device than before answers at %1: it was &quot;%2&quot; and is &quot;%3&quot;. Nothing is written to it. Put the plugs right, or say on the Rig page that this is the one.</source>
        <translation>Un autre appareil que d’habitude répond sur %1 : c’était « %2 », c’est « %3 ». Rien ne lui est écrit. Remettez les prises en ordre, ou dites sur la page Banc que c’est le bon.</translation>
    </message>
    <message>
        <source>The heat of the real rig (%1) is not known to be off, and Bask no longer watches it. Check the plate, and switch it off at its mains.</source>
        <translation>Le chauffage du banc réel (%1) n’est pas connu comme éteint, et Bask ne le surveille plus. Vérifiez la plaque et coupez-la au secteur.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2 and did not follow its object&apos;s heat. Check that the sensor is on its object, then confirm it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» indique %2 et n’a pas suivi la chaleur de son objet. Vérifiez que le capteur est sur son objet, puis confirmez-le.</translation>
    </message>
    <message>
        <source>what the air takes is unknown and not counted: in air objects settle colder than told here; state the convection of the air in the experiment</source>
        <translation>ce que l’air emporte est inconnu et n’est pas compté&#xa0;: dans l’air les objets se stabilisent plus froids qu’indiqué ici&#xa0;; indiquez la convection de l’air dans l’expérience</translation>
    </message>
    <message>
        <source>this record cannot tell radiation from what the air takes: only the loss of both together and its slope at %1 are certain; state the convection of the air in the experiment, or record wide temperatures</source>
        <translation>cet enregistrement ne distingue pas le rayonnement de ce que l’air emporte&#xa0;: seules la perte des deux ensemble et sa pente à %1 sont sûres&#xa0;; indiquez la convection de l’air dans l’expérience, ou enregistrez des températures étendues</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at the start pose</source>
        <translation>%1 prend %2&#xa0;% de la lumière de %3 à la pose de départ</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at this pose</source>
        <translation>%1 prend %2&#xa0;% de la lumière de %3 à cette pose</translation>
    </message>
    <message>
        <source>the list is empty; leave it out for a source that is even</source>
        <translation>la liste est vide ; omettez-la pour une source uniforme</translation>
    </message>
    <message>
        <source>this part of the source overlaps %1; parts may touch but not cover one another</source>
        <translation>cette partie de la source chevauche %1 ; les parties peuvent se toucher mais pas se recouvrir</translation>
    </message>
    <message>
        <source>this part reaches %1 mm beyond the source&apos;s contour; move it or make the contour larger</source>
        <translation>cette partie dépasse le contour de la source de %1 mm ; déplacez-la ou agrandissez le contour</translation>
    </message>
    <message>
        <source>this part stands %1 mm out of the source&apos;s plane, from which clearances are measured; lower it, or move the source&apos;s pose up</source>
        <translation>cette partie dépasse de %1 mm le plan de la source, à partir duquel les distances de sécurité sont mesurées ; abaissez-la ou relevez la pose de la source</translation>
    </message>
    <message>
        <source>this part of the source stands on edge or faces away; tilt it by less than 89 degrees</source>
        <translation>cette partie de la source est sur la tranche ou tournée de l&apos;autre côté ; inclinez-la de moins de 89 degrés</translation>
    </message>
    <message>
        <source>this part lies in front of %1; what parts of a source hide from one another is not computed</source>
        <translation>cette partie se trouve devant %1 ; ce que les parties d&apos;une source se cachent l&apos;une à l&apos;autre n&apos;est pas calculé</translation>
    </message>
    <message>
        <source>the radii must grow, but %1 mm comes after %2 mm</source>
        <translation>les rayons doivent croître, mais %1 mm vient après %2 mm</translation>
    </message>
    <message>
        <source>a radial profile needs a source whose contour is a disk without holes</source>
        <translation>un profil radial demande une source dont le contour est un disque sans trous</translation>
    </message>
    <message>
        <source>the first line must name two columns: the radius (radius_mm, radius_cm or radius_m) and temperature_ratio or temperature_offset_K</source>
        <translation>la première ligne doit nommer deux colonnes : le rayon (radius_mm, radius_cm ou radius_m) et temperature_ratio ou temperature_offset_K</translation>
    </message>
    <message>
        <source>line %1: two numbers expected, &quot;%2&quot; found</source>
        <translation>ligne %1 : deux nombres attendus, « %2 » trouvé</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each object, fixture and shield its own</source>
        <translation>le nom «&#xa0;%1&#xa0;» est utilisé deux fois&#xa0;; donnez à chaque objet, support et écran le sien</translation>
    </message>
    <message>
        <source>every object, fixture and shield needs a name</source>
        <translation>chaque objet, chaque support et chaque écran doit avoir un nom</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed, since the shield &quot;%4&quot; reaches up to %5 mm and everything held stays above it</source>
        <translation>au départ, «&#xa0;%1&#xa0;» est à %2&#xa0;mm du plan de la source&#xa0;; il faut au moins %3&#xa0;mm, car l’écran «&#xa0;%4&#xa0;» monte jusqu’à %5&#xa0;mm et tout ce qui est porté reste au-dessus</translation>
    </message>
    <message>
        <source>the lowest point of this shield is %1 mm over the source plane; at least %2 mm are needed</source>
        <translation>le point le plus bas de cet écran est à %1&#xa0;mm au-dessus du plan de la source&#xa0;; il faut au moins %2&#xa0;mm</translation>
    </message>
    <message>
        <source>the camera&apos;s pose in the robot&apos;s base is not known</source>
        <translation>la pose de la caméra dans la base du robot n’est pas connue</translation>
    </message>
    <message>
        <source>the robot&apos;s place is not sure, so nobody knows where in the picture it is</source>
        <translation>la position du robot n’est pas sûre, donc nul ne sait où il est dans l’image</translation>
    </message>
    <message>
        <source>the camera is not zeroed on it; it has to see the object as cold as the room, before any heat</source>
        <translation>la caméra n’est pas ajustée sur lui&#xa0;; elle doit voir l’objet aussi froid que la pièce, avant tout chauffage</translation>
    </message>
    <message>
        <source>its face reflects the source, whose temperature is not known</source>
        <translation>sa face réfléchit la source, dont la température n’est pas connue</translation>
    </message>
    <message>
        <source>it is above %1, where the camera&apos;s numbers are known to be wrong</source>
        <translation>il est au-dessus de %1, où les nombres de la caméra sont connus pour être faux</translation>
    </message>
    <message>
        <source>the camera&apos;s last picture is %1 s old</source>
        <translation>la dernière image de la caméra date de %1 s</translation>
    </message>
    <message>
        <source>the lens model has no line of sight for some pixels; calibrate the camera again</source>
        <translation>le modèle de l’objectif n’a pas de ligne de visée pour certains pixels&#xa0;; étalonnez de nouveau la caméra</translation>
    </message>
    <message>
        <source>no pictures of a thermal camera were recorded; set sampling.thermal_frame_period_s before a run</source>
        <translation>aucune image de caméra thermique n’a été enregistrée&#xa0;; fixez sampling.thermal_frame_period_s avant un essai</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be read by a thermal camera, and the rig has none; give the rig one, or read the object by &quot;contact&quot;</source>
        <translation>«&#xa0;%1&#xa0;» doit être lu par une caméra thermique, et le banc n’en a pas&#xa0;; donnez-en une au banc, ou lisez l’objet par «&#xa0;contact&#xa0;»</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: within the last %3 s their readings changed as if each were on the other object, as the thermal camera sees both. The heat is off. Check both, confirm them, then reset.</source>
        <translation>Les capteurs de « %1 » et « %2 » semblent échangés : dans les %3 dernières secondes, leurs valeurs ont changé comme si chacun était sur l’autre objet, tels que la caméra thermique les voit. Le chauffage est coupé. Vérifiez les deux, confirmez-les, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4, and no emittance explains that. The sensor may be off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» indique %2, mais la caméra thermique voit l’objet à %3, à %4 près, et aucune émissivité n’explique cela. Le capteur est peut-être décollé de son objet. Le chauffage est coupé. Fixez le capteur, confirmez-le, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4; both agreed %5 s ago. The sensor has come off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» indique %2, mais la caméra thermique voit l’objet à %3, à %4 près&#xa0;; les deux s’accordaient il y a %5 s. Le capteur est décollé de son objet. Le chauffage est coupé. Fixez le capteur, confirmez-le, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The thermal camera cannot read &quot;%1&quot;: %2.</source>
        <translation>La caméra thermique ne peut pas lire «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Both agree if the emittance of its face is %5 instead of %6. Measure the emittance, and check that the sensor is fastened well.</source>
        <translation>La caméra thermique voit «&#xa0;%1&#xa0;» à %2, à %3 près, mais son capteur indique %4. Les deux s’accordent si l’émissivité de sa face vaut %5 au lieu de %6. Mesurez l’émissivité, et vérifiez que le capteur est bien fixé.</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Check the sensor, that nothing is before the camera, and that the camera has not been moved.</source>
        <translation>La caméra thermique voit «&#xa0;%1&#xa0;» à %2, à %3 près, mais son capteur indique %4. Vérifiez le capteur, que rien n’est devant la caméra, et qu’elle n’a pas été déplacée.</translation>
    </message>
    <message>
        <source>The thermal camera cannot check the sensor of &quot;%1&quot;: %2.</source>
        <translation>La caméra thermique ne peut pas vérifier le capteur de «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>A step of the robot took over twice its time and was stopped. Its controller&apos;s rates ($110 to $115) or accelerations ($120 to $125) are too small for the largest speed of the experiment, or it is blocked. Check both, then reset.</source>
        <translation>Un pas du robot a pris plus de deux fois son temps et a été arrêté. Les vitesses ($110 à $115) ou les accélérations ($120 à $125) de son contrôleur sont trop petites pour la plus grande vitesse de l’expérience, ou il est bloqué. Vérifiez les deux, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The robot cannot follow the largest speed of the experiment, because its controller has %1: a step takes %2 s instead of %3 s, and a retreat up to %4 s. Raise that setting, or set a smaller largest speed.</source>
        <translation>Le robot ne peut pas suivre la plus grande vitesse de l’expérience, car son contrôleur a %1&#xa0;: un pas prend %2 s au lieu de %3 s, et un retrait jusqu’à %4 s. Augmentez ce réglage, ou abaissez la vitesse maximale de l’expérience.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; was not confirmed on this computer, or has changed since. Bask does not start it. Look at it, then confirm it on the Rig page, or allow it with --allow-program where there is no window.</source>
        <translation>le programme «&#xa0;%1&#xa0;» n’a pas été confirmé sur cet ordinateur, ou a changé depuis. Bask ne le lance pas. Examinez-le, puis confirmez-le sur la page Banc, ou autorisez-le par --allow-program là où il n’y a pas de fenêtre.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; cannot be started: %2. Check its command on the Rig page.</source>
        <translation>le programme «&#xa0;%1&#xa0;» ne peut pas être lancé&#xa0;: %2. Vérifiez sa commande sur la page Banc.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has ended: %2. Bask starts it again. If it ends again, try it with &quot;bask check-device&quot;.</source>
        <translation>le programme «&#xa0;%1&#xa0;» s’est terminé&#xa0;: %2. Bask le relance. S’il se termine encore, essayez-le avec «&#xa0;bask check-device&#xa0;».</translation>
    </message>
    <message>
        <source>Bask has ended the program &quot;%1&quot;: %2. It starts it again. If this happens again, try it with &quot;bask check-device&quot;.</source>
        <translation>Bask a mis fin au programme «&#xa0;%1&#xa0;»&#xa0;: %2. Il le relance. Si cela se reproduit, essayez-le avec «&#xa0;bask check-device&#xa0;».</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has not answered for %2 s. Check the device behind it and its link.</source>
        <translation>le programme «&#xa0;%1&#xa0;» n’a pas répondu depuis %2 s. Vérifiez l’appareil derrière lui et sa liaison.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; does not fit the rig: %2. Change the program, or the device on the Rig page.</source>
        <translation>le programme «&#xa0;%1&#xa0;» ne convient pas au banc&#xa0;: %2. Changez le programme, ou l’appareil sur la page Banc.</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; refuses a command: %2. Remove the cause, clear the alarm of a robot, then reset.</source>
        <translation>le programme «&#xa0;%1&#xa0;» refuse un ordre&#xa0;: %2. Supprimez la cause, effacez l’alarme d’un robot, puis réarmez.</translation>
    </message>
    <message>
        <source>The robot does not move: %1. Remove the cause, clear the alarm, then reset.</source>
        <translation>Le robot ne bouge pas&#xa0;: %1. Supprimez la cause, effacez l’alarme, puis réarmez.</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; is confirmed on this computer</source>
        <translation>Le programme «&#xa0;%1&#xa0;» est confirmé sur cet ordinateur</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; is in the hands of a person at the console: Bask takes it back 3 s after the last that is sent by hand.</source>
        <translation>la liaison avec «&#xa0;%1&#xa0;» est entre les mains d’une personne à la console&#xa0;: Bask la reprend 3 s après le dernier envoi à la main.</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2, which is %3 times that: its numbers mean something else than its profile says. It is not heated. Set device and profile to the same scale, then reset.</source>
        <translation>La source a été réglée sur %1 mais relit %2, soit %3 fois cela&#xa0;: ses nombres signifient autre chose que ce que dit son profil. Elle n’est pas chauffée. Mettez l’appareil et le profil à la même échelle, puis réinitialisez.</translation>
    </message>
    <message>
        <source>Sent by hand to &quot;%1&quot;: %2</source>
        <translation>Envoyé à la main à «&#xa0;%1&#xa0;»&#xa0;: %2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is not reached: %2</source>
        <translation>surveillance&#xa0;: le courtier %1 n’est pas joint&#xa0;: %2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is too slow; %2 messages were left out</source>
        <translation>surveillance&#xa0;: le courtier %1 est trop lent&#xa0;; %2 messages ont été omis</translation>
    </message>
    <message>
        <source>monitoring: the status file is not written: %1</source>
        <translation>surveillance&#xa0;: le fichier d’état n’est pas écrit&#xa0;: %1</translation>
    </message>
    <message>
        <source>others can read this file, which holds a password; let its owner alone read it (chmod 600)</source>
        <translation>d’autres peuvent lire ce fichier, qui contient un mot de passe&#xa0;; ne laisser que son propriétaire le lire (chmod 600)</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a broker; give its name, with a colon and the port if that is not the usual one</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas l’adresse d’un courtier&#xa0;; donner son nom, avec deux-points et le port si ce n’est pas celui d’usage</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no topic: letters, digits, dots, hyphens and underscores in parts between slashes, at most 128 characters</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un sujet&#xa0;: lettres, chiffres, points, traits d’union et traits de soulignement, en parties séparées par des barres, 128 caractères au plus</translation>
    </message>
    <message>
        <source>this installation of Bask cannot speak to a broker: %1</source>
        <translation>cette installation de Bask ne peut pas parler à un courtier&#xa0;: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no date; write year, month and day as in 2026-11-23</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une date&#xa0;; écrivez année, mois et jour comme dans 2026-11-23</translation>
    </message>
    <message>
        <source>two materials are named &quot;%1&quot;; give each its own name</source>
        <translation>deux matériaux se nomment «&#xa0;%1&#xa0;»&#xa0;; donnez à chacun son propre nom</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; were exchanged: they read %3 and %4 where %5 and %6 were expected. The heat is off. See that each is on its own object, confirm both, then reset.</source>
        <translation>Les capteurs de « %1 » et « %2 » ont été échangés : ils lisent %3 et %4 là où %5 et %6 étaient attendus. Le chauffage est coupé. Vérifiez que chacun est sur son objet, confirmez les deux, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The objects are cold: the recording ends</source>
        <translation>Les objets sont froids&#xa0;: l’enregistrement prend fin</translation>
    </message>
    <message>
        <source>The recording after the run has ended before all was cold: the experiment was changed, another one was opened, a person has heated the source, or 6 h have passed.</source>
        <translation>L’enregistrement après l’essai s’est terminé avant que tout soit froid&#xa0;: l’expérience a été modifiée, une autre a été ouverte, une personne a chauffé la source, ou 6&#xa0;h se sont écoulées.</translation>
    </message>
    <message>
        <source>the thermal camera&apos;s place is not known well enough for so small an object; measure it on the Calibrate page, Place</source>
        <translation>la position de la caméra thermique n’est pas connue assez précisément pour un objet aussi petit ; mesurez-la à la page Étalonner, onglet Place</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is not what the thermal camera that reads it can tell: %3 to %4 with this emittance. Change the target, or let a sensor read the object.</source>
        <translation>La consigne de « %1 », %2, n’est pas ce que la caméra thermique qui le lit peut indiquer : de %3 à %4 avec cette émissivité. Changez la consigne, ou laissez un capteur lire l’objet.</translation>
    </message>
    <message>
        <source>Ready in %1 s: the first readings are being collected.</source>
        <translation>Prêt dans %1 s : les premières mesures sont en cours d’acquisition.</translation>
    </message>
    <message>
        <source>the order was not taken (simulated)</source>
        <translation>l’ordre n’a pas été pris (simulé)</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: what they read in the last %3 s agrees with the heat of the other object, not with that of their own. The heat is off. Check both, confirm them, then reset.</source>
        <translation>Les capteurs de « %1 » et « %2 » semblent échangés : ce qu’ils ont indiqué dans les %3 dernières secondes s’accorde avec la chaleur de l’autre objet, non avec celle du leur. Le chauffage est coupé. Vérifiez les deux, confirmez-les, puis réinitialisez.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; warms by %2/s; the source explains at most %3/s: something else heats it, or its sensor is not on it. Bask switches the heat off. Check both, then reset.</source>
        <translation>« %1 » chauffe de %2/s ; la source explique au plus %3/s : autre chose le chauffe, ou son capteur n’est pas sur lui. Bask coupe le chauffage. Vérifiez les deux, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The source is at %1, %2 above its set point, and does not cool. Check its controller and its sensor; Stop takes the objects away and switches the heat off.</source>
        <translation>La source est à %1, %2 au-dessus de sa consigne, et ne refroidit pas. Vérifiez son régulateur et son capteur ; Arrêter éloigne les objets et coupe le chauffage.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, %3 from its target, and has gone farther from it for %4 s. Its sensor may be on another object, its outline or its mounting may be wrong, or something heats or cools it. The run goes on: check these.</source>
        <translation>« %1 » est à %2, à %3 de sa consigne, et s’en éloigne depuis %4 s. Son capteur est peut-être sur un autre objet, son contour ou sa fixation sont peut-être faux, ou quelque chose le chauffe ou le refroidit. L’essai continue : vérifiez-les.</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which is not in the drawing (no other file is opened); put it there, or take the &lt;use&gt; out</source>
        <translation>ligne&#xa0;%1&#xa0;: &lt;use&gt; dessine «&#xa0;%2&#xa0;», qui n’est pas dans le dessin (aucun autre fichier n’est ouvert)&#xa0;; mettez-le dans le dessin, ou retirez le &lt;use&gt;</translation>
    </message>
    <message>
        <source>line %1: the points of &lt;%2&gt; are damaged from &quot;%3&quot; on</source>
        <translation>ligne&#xa0;%1&#xa0;: les points de &lt;%2&gt; sont endommagés à partir de «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>line %1: the %2 of &lt;%3&gt;, &quot;%4&quot;, is no length; write a number, with px, mm, cm, in, pt, pc or % if it has a unit</source>
        <translation>ligne&#xa0;%1&#xa0;: l’attribut %2 de &lt;%3&gt;, «&#xa0;%4&#xa0;», n’est pas une longueur&#xa0;; écrivez un nombre, suivi de px, mm, cm, in, pt, pc ou % s’il a une unité</translation>
    </message>
    <message>
        <source>line %1: the transform of &lt;%2&gt; is damaged from &quot;%3&quot; on</source>
        <translation>ligne&#xa0;%1&#xa0;: la transformation de &lt;%2&gt; est endommagée à partir de «&#xa0;%3&#xa0;»</translation>
    </message>
    <message>
        <source>a chessboard or the like: there are too many quadrangles to find a marker among them; cut the markers out</source>
        <translation>un damier ou semblable&#xa0;: il y a trop de quadrilatères pour y trouver un marqueur&#xa0;; découpez les marqueurs</translation>
    </message>
    <message>
        <source>the file holds %1 frames of &quot;%2&quot; one after another; choose one by its number (thermal-frame --frame), or save one frame (%3 bytes) a file</source>
        <translation>le fichier contient %1 images de « %2 » à la suite ; choisissez-en une par son numéro (thermal-frame --frame), ou enregistrez une image (%3 octets) par fichier</translation>
    </message>
    <message>
        <source>the file holds %1 pictures; choose one by its number (thermal-frame --frame), or save one picture a file</source>
        <translation>le fichier contient %1 images ; choisissez-en une par son numéro (thermal-frame --frame), ou enregistrez une image par fichier</translation>
    </message>
    <message>
        <source>its face reflects the source, whose place is not known; let the source be seen, or aim the camera at the backs of the objects</source>
        <translation>sa face réfléchit la source, dont la position n’est pas connue&#xa0;; rendez la source visible, ou visez le dos des objets</translation>
    </message>
    <message>
        <source>where &quot;%1&quot; has temperatures, this frame holds a plain picture; its halves are exchanged, or the camera sends no temperatures. Record it again as the camera sends it</source>
        <translation>là où « %1 » a des températures, cette image contient une vue ordinaire ; ses moitiés sont échangées, ou la caméra n’envoie pas de températures. Enregistrez-la de nouveau telle que la caméra l’envoie</translation>
    </message>
    <message>
        <source>all pixels are between %1 and %2, as the bytes of a plain grey picture would be; make sure that the camera looks at something that hot</source>
        <translation>tous les pixels sont entre %1 et %2, comme le seraient les octets d’une vue ordinaire en gris ; assurez-vous que la caméra regarde quelque chose d’aussi chaud</translation>
    </message>
    <message>
        <source>line %1 counts up by one, as a line of column numbers does, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the line</source>
        <translation>la ligne %1 compte de un en un, comme une ligne de numéros de colonnes, et rien ne dit si ce sont des températures ; nommez le profil de la caméra, dont la taille le dit, ou supprimez la ligne</translation>
    </message>
    <message>
        <source>the first column counts up by one, as line numbers do, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the column</source>
        <translation>la première colonne compte de un en un, comme des numéros de lignes, et rien ne dit si ce sont des températures ; nommez le profil de la caméra, dont la taille le dit, ou supprimez la colonne</translation>
    </message>
    <message>
        <source>there is no frame %1: the file holds %2, counted from 1</source>
        <translation>il n’y a pas d’image %1 : le fichier en contient %2, comptées à partir de 1</translation>
    </message>
    <message>
        <source>the bytes are those of %1 frames of &quot;%2&quot; or, with its optional rows, of %3, and nothing tells which; save one frame a file</source>
        <translation>les octets sont ceux de %1 images de « %2 » ou, avec ses lignes facultatives, de %3, et rien ne dit lequel ; enregistrez une image par fichier</translation>
    </message>
    <message>
        <source>it is a BigTIFF, which is not read; save it as an ordinary TIFF, or as PNG</source>
        <translation>c’est un BigTIFF, qui n’est pas lu ; enregistrez-le comme TIFF ordinaire, ou en PNG</translation>
    </message>
    <message>
        <source>case %1 is also in %2, with other bytes: one of the two parts was changed; leave it out, or delete it and run its shard again</source>
        <translation>le cas&#xa0;%1 est aussi dans %2, avec d’autres octets&#xa0;: l’une des deux parties a été modifiée&#xa0;; laissez-la de côté, ou supprimez-la et relancez sa part</translation>
    </message>
    <message>
        <source>warning limit of &quot;%1&quot;</source>
        <translation>limite d’avertissement de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>trip limit of &quot;%1&quot;</source>
        <translation>limite de déclenchement de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>lowest %1</source>
        <translation>minimum de %1</translation>
    </message>
    <message>
        <source>highest %1</source>
        <translation>maximum de %1</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>axe %1</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>The robot&apos;s link is there, but the robot has reported or obeyed nothing for %1 s: its controller is busy, blocked or held. The heat is off. Look at the robot and its controller, then reset.</source>
        <translation>La liaison du robot est là, mais le robot n’a rien signalé ni exécuté depuis %1 s : son contrôleur est occupé, bloqué ou retenu. Le chauffage est coupé. Regardez le robot et son contrôleur, puis réinitialisez.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2 and warms by %3/s with the heat off; the source explains at most %4/s. Something else heats it, or its sensor has just been put on it. Look at it before it reaches its limits.</source>
        <translation>« %1 » est à %2 et chauffe de %3/s alors que le chauffage est coupé ; la source explique au plus %4/s. Autre chose le chauffe, ou son capteur vient d’être posé sur lui. Regardez-le avant qu’il n’atteigne ses limites.</translation>
    </message>
    <message>
        <source>The robot does not answer: %1. What it holds stays where it is, perhaps before a hot source. Check its link, then reset and retreat.</source>
        <translation>Le robot ne répond pas&#xa0;:&#xa0;%1. Ce qu’il tient reste où il est, peut-être devant une source chaude. Vérifiez sa liaison, puis réinitialisez et retirez les objets.</translation>
    </message>
    <message>
        <source>STOP was pressed: the robot stands still and the heat is off. What it holds stays where it is, perhaps before a hot source. Reset when it is safe, and retreat.</source>
        <translation>STOP a été pressé&#xa0;: le robot est immobile et le chauffage coupé. Ce qu’il tient reste où il est, peut-être devant une source chaude. Réinitialisez quand tout est sûr, et retirez les objets.</translation>
    </message>
    <message>
        <source>simulated fault removed: %1</source>
        <translation>défaut simulé supprimé : %1</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. By now the object may be anywhere from %3 to %4, where its wrong readings were too, so Bask cannot tell whether this one is right. Check that the sensor is on its object, then confirm it.</source>
        <translation>Le capteur de «&#xa0;%1&#xa0;» indique %2. L’objet peut maintenant être n’importe où entre %3 et %4, où étaient aussi ses valeurs fausses&#xa0;: Bask ne peut pas savoir si celle-ci est juste. Vérifiez que le capteur est sur son objet, puis confirmez-le.</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due. Its sensor may be off or on another object, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check these, then reset.</source>
        <translation>La température de « %1 » ne suit pas sa chaleur : en %3 s elle a changé de %4 là où %2, ou plus dans ce sens, était attendu. Son capteur est peut-être décollé ou sur un autre objet, l’objet est peut-être parti, ou la source est ailleurs que prévu. Bask coupe le chauffage. Vérifiez tout cela, puis réinitialisez.</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due, and &quot;%5&quot; deviates the other way. Their sensors may be swapped, or that of &quot;%1&quot; is off. Bask switches the heat off. Check both, then reset.</source>
        <translation>La température de « %1 » ne suit pas sa chaleur : en %3 s elle a changé de %4 là où %2, ou plus dans ce sens, était attendu, et « %5 » s’écarte dans l’autre sens. Leurs capteurs sont peut-être échangés, ou celui de « %1 » est décollé. Bask coupe le chauffage. Vérifiez les deux, puis réinitialisez.</translation>
    </message>
</context>
<context>
    <name>OutlinePainting</name>
    <message>
        <source>1 harmonic</source>
        <translation>1 harmonique</translation>
    </message>
    <message>
        <source>%1 harmonics</source>
        <translation>%1 harmoniques</translation>
    </message>
    <message>
        <source>1 hole</source>
        <translation>1 trou</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 trous</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Objects: warning</source>
        <translation>Objets : avertissement</translation>
    </message>
    <message>
        <source>A run holds, and a priority 2 alarm is given</source>
        <translation>L’essai se met en pause, avec une alarme de priorité 2</translation>
    </message>
    <message>
        <source>Objects: trip</source>
        <translation>Objets : déclenchement</translation>
    </message>
    <message>
        <source>Heat off and retreat. What object, paint and sensor bear.</source>
        <translation>Chauffage coupé et retrait. Ce que supportent l’objet, la peinture et le capteur.</translation>
    </message>
    <message>
        <source>Source: trip</source>
        <translation>Source : déclenchement</translation>
    </message>
    <message>
        <source>Heat off and retreat. Automatic: 50 K over the highest set point.</source>
        <translation>Chauffage coupé et retrait. Automatique : 50 K au-dessus de la consigne la plus haute.</translation>
    </message>
    <message>
        <source>Periods a reading is good for</source>
        <translation>Périodes de validité d’une mesure</translation>
    </message>
    <message>
        <source>A sensor without a newer one is lost; also the source and its place</source>
        <translation>Un capteur sans mesure plus récente est perdu ; de même la source et sa position</translation>
    </message>
    <message>
        <source>Longest hold</source>
        <translation>Pause la plus longue</translation>
    </message>
    <message>
        <source>A lost sensor or source holds the run so long, then it ends with a retreat</source>
        <translation>Un capteur ou une source perdus mettent l’essai en pause aussi longtemps, puis il finit par un retrait</translation>
    </message>
    <message>
        <source>Fastest plausible change</source>
        <translation>Variation plausible maximale</translation>
    </message>
    <message>
        <source>Faster readings are a jump, and no heat. Automatic: three times what the source can do to the object, 2 K/s at least.</source>
        <translation>Plus vite, c’est un saut et non de la chaleur. Automatique : trois fois ce que la source peut faire à l’objet, 2 K/s au moins.</translation>
    </message>
    <message>
        <source>Jumps in a row</source>
        <translation>Sauts de suite</translation>
    </message>
    <message>
        <source>So many readings that are too fast are a sensor fault</source>
        <translation>Autant de mesures trop rapides sont un défaut du capteur</translation>
    </message>
    <message>
        <source>Frozen sensor after</source>
        <translation>Capteur figé après</translation>
    </message>
    <message>
        <source>The very same reading for so long, though the object must have changed</source>
        <translation>La même mesure aussi longtemps, alors que l’objet a dû changer</translation>
    </message>
    <message>
        <source>Change that must be seen</source>
        <translation>Variation à constater</translation>
    </message>
    <message>
        <source>An object that must have changed by so much and did not does not follow its heat</source>
        <translation>Un objet qui aurait dû varier d’autant et ne l’a pas fait ne suit pas sa chaleur</translation>
    </message>
    <message>
        <source>Sensors apart when cold</source>
        <translation>Écart des capteurs à froid</translation>
    </message>
    <message>
        <source>Sensors of a cold rig that differ by more are told</source>
        <translation>Les capteurs d’un banc froid qui diffèrent de plus sont signalés</translation>
    </message>
    <message>
        <source>Source: time to gain 2 K</source>
        <translation>Source : temps pour gagner 2 K</translation>
    </message>
    <message>
        <source>A source that is too cold and no nearer after so long does not heat</source>
        <translation>Une source trop froide qui ne s’est pas rapprochée après ce temps ne chauffe pas</translation>
    </message>
    <message>
        <source>Source: near its set point</source>
        <translation>Source : près de sa consigne</translation>
    </message>
    <message>
        <source>Within this the source is not too cold</source>
        <translation>À moins de cet écart, la source n’est pas trop froide</translation>
    </message>
    <message>
        <source>Source: warming unasked</source>
        <translation>Source : chauffe non demandée</translation>
    </message>
    <message>
        <source>More warming with the heat off is an alarm</source>
        <translation>Chauffer davantage, chauffage coupé, est une alarme</translation>
    </message>
    <message>
        <source>Least room on the disk</source>
        <translation>Place minimale sur le disque</translation>
    </message>
    <message>
        <source>With less no recording is begun</source>
        <translation>Avec moins, aucun enregistrement ne commence</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Trip</source>
        <translation>Déclenchement</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>Émissivité</translation>
    </message>
    <message>
        <source>Absorptance</source>
        <translation>Absorptivité</translation>
    </message>
    <message>
        <source>Specific heat</source>
        <translation>Chaleur massique</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Masse volumique</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Largest speed</source>
        <translation>Plus grande vitesse</translation>
    </message>
    <message>
        <source>Largest turning speed</source>
        <translation>Plus grande vitesse de rotation</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Plus grande accélération</translation>
    </message>
    <message>
        <source>Largest turning acceleration</source>
        <translation>Plus grande accélération de rotation</translation>
    </message>
    <message>
        <source>Clearance to the source</source>
        <translation>Distance de garde à la source</translation>
    </message>
    <message>
        <source>Least distance of any point of an object from the source&apos;s plane</source>
        <translation>Plus petite distance de tout point d’un objet au plan de la source</translation>
    </message>
    <message>
        <source>Largest mounting radius</source>
        <translation>Plus grand rayon de montage</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sans limite</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>heat without a watchdog</source>
        <translation>chauffage sans chien de garde</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>interdit</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>permis</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>Constante de temps</translation>
    </message>
    <message>
        <source>Wanted rate = error / time constant: shorter is faster and rougher.</source>
        <translation>Vitesse voulue = écart / constante de temps&#xa0;: plus courte, plus rapide et plus brusque.</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>Temps intégral</translation>
    </message>
    <message>
        <source>Of the slow integral action near the target.</source>
        <translation>De l’action intégrale lente près de la consigne.</translation>
    </message>
    <message>
        <source>Damping D</source>
        <translation>Amortissement D</translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation>Raideur K</translation>
    </message>
    <message>
        <source>Weight of the error μ</source>
        <translation>Poids de l’écart μ</translation>
    </message>
    <message>
        <source>ζ = v + μ Δτ</source>
        <translation>ζ = v + μ Δτ</translation>
    </message>
    <message>
        <source>Feedback K</source>
        <translation>Rétroaction K</translation>
    </message>
    <message>
        <source>Of ζ in the velocity command</source>
        <translation>De ζ dans la commande de vitesse</translation>
    </message>
    <message>
        <source>Adaptation γ₁</source>
        <translation>Adaptation γ₁</translation>
    </message>
    <message>
        <source>Speed at which 1/λ₁ is adapted</source>
        <translation>Rapidité d’adaptation de 1/λ₁</translation>
    </message>
    <message>
        <source>Adaptation γ₂</source>
        <translation>Adaptation γ₂</translation>
    </message>
    <message>
        <source>Speed at which λ₂/λ₁ is adapted</source>
        <translation>Rapidité d’adaptation de λ₂/λ₁</translation>
    </message>
    <message>
        <source>dv/dt = −D v − K Δτ</source>
        <translation>dv/dt = −D v − K Δτ</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unité</translation>
    </message>
    <message>
        <source>The device&apos;s Modbus address</source>
        <translation>L’adresse Modbus de l’appareil</translation>
    </message>
    <message>
        <source>Watchdog</source>
        <translation>Chien de garde</translation>
    </message>
    <message>
        <source>The device switches its heat off when it has heard nothing for so long</source>
        <translation>L’appareil coupe son chauffage s’il n’entend rien pendant ce temps</translation>
    </message>
    <message>
        <source>Convection h</source>
        <translation>Convection h</translation>
    </message>
    <message>
        <source>What the air takes from an object&apos;s face, by its temperature above the room</source>
        <translation>Ce que l’air emporte de la face d’un objet, selon sa température au-dessus de la pièce</translation>
    </message>
    <message>
        <source>a figure drawn by Bask</source>
        <translation>une figure dessinée par Bask</translation>
    </message>
    <message>
        <source>a report written by Bask</source>
        <translation>un rapport écrit par Bask</translation>
    </message>
    <message>
        <source>a table written by Bask</source>
        <translation>un tableau écrit par Bask</translation>
    </message>
    <message>
        <source>a comparison written by Bask</source>
        <translation>une comparaison écrite par Bask</translation>
    </message>
    <message>
        <source>a NeXus file written by Bask</source>
        <translation>un fichier NeXus écrit par Bask</translation>
    </message>
    <message>
        <source>lines written by Bask</source>
        <translation>un fichier de lignes écrit par Bask</translation>
    </message>
    <message>
        <source>a collection written by Bask</source>
        <translation>une collection écrite par Bask</translation>
    </message>
    <message>
        <source>a field written by Bask</source>
        <translation>un champ écrit par Bask</translation>
    </message>
    <message>
        <source>a surface file written by Bask</source>
        <translation>un fichier de surfaces écrit par Bask</translation>
    </message>
    <message>
        <source>it is written to again and again</source>
        <translation>on y écrit sans cesse</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>theta x</source>
        <translation>thêta x</translation>
    </message>
    <message>
        <source>theta y</source>
        <translation>thêta y</translation>
    </message>
    <message>
        <source>theta z</source>
        <translation>thêta z</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>fixe</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
</context>
<context>
    <name>PoseWords</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3; turned by %4, %5, %6 about x, y, z</source>
        <translation>x %1, y %2, z %3 ; tournée de %4, %5, %6 autour de x, y, z</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Idle</source>
        <translation>Au repos</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>Pas prêt</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armé</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>En marche</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Stabilisé</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>Arrêt en cours</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Fault (latched)</source>
        <translation>Défaut (verrouillé)</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Connexion en cours</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Prise d’origine en cours</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>Terminée</translation>
    </message>
</context>
<context>
    <name>Verb</name>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Désarmer</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>Retrait</translation>
    </message>
    <message>
        <source>Set targets</source>
        <translation>Fixer les consignes</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Déplacement manuel</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Prise d’origine</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Chauffer</translation>
    </message>
    <message>
        <source>Confirm sensor</source>
        <translation>Confirmer le capteur</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>Effacer l’alarme</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>Mettre de côté</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>Reprendre</translation>
    </message>
</context>
<context>
    <name>bask::Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>E&amp;xemples</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;New experiment</source>
        <translation>&amp;Nouvelle expérience</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open an experiment (*.json) or a recorded session (*.bask)</source>
        <translation>Ouvrir une expérience (*.json) ou une session enregistrée (*.bask)</translation>
    </message>
    <message>
        <source>&amp;Save experiment</source>
        <translation>&amp;Enregistrer l’expérience</translation>
    </message>
    <message>
        <source>Save experiment &amp;as…</source>
        <translation>Enregistrer l’expérience &amp;sous…</translation>
    </message>
    <message>
        <source>Save sess&amp;ion…</source>
        <translation>Enregistrer la sess&amp;ion…</translation>
    </message>
    <message>
        <source>Copy the recording of the present or last run to a file of your choice</source>
        <translation>Copier l’enregistrement de l’essai en cours ou du dernier dans un fichier de votre choix</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;About Bask</source>
        <translation>À propos de &amp;Bask</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Essai</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>&amp;Armer</translation>
    </message>
    <message>
        <source>Zero the sensors at ambient and open the recording. Nothing moves or heats yet.</source>
        <translation>Ajuster les capteurs à l’ambiante et ouvrir l’enregistrement. Rien ne bouge ni ne chauffe encore.</translation>
    </message>
    <message>
        <source>S&amp;tart</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>Open the heat and servo every object to its target.</source>
        <translation>Ouvrir le chauffage et asservir chaque objet à sa consigne.</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Zero velocity; the controller keeps its state and Resume goes on from here.</source>
        <translation>Vitesse nulle&#xa0;; le régulateur garde son état et Reprendre continue d’ici.</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>Repre&amp;ndre</translation>
    </message>
    <message>
        <source>Go on from where the run was held.</source>
        <translation>Continuer là où l’essai a été mis en pause.</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>End the run: heat off, retreat upwards, close the recording. While armed: disarm.</source>
        <translation>Terminer l’essai&#xa0;: chauffage coupé, retrait vers le haut, enregistrement clos. Si armé&#xa0;: désarmer.</translation>
    </message>
    <message>
        <source>STOP now</source>
        <translation>STOP immédiat</translation>
    </message>
    <message>
        <source>Zero velocity and heat off now, latched. A software stop, not a safety-rated emergency stop.</source>
        <translation>Vitesse nulle et chauffage coupé immédiatement, verrouillé. Arrêt logiciel, et non arrêt d’urgence de sécurité.</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>Réin&amp;itialiser</translation>
    </message>
    <message>
        <source>Clear a latched stop or fault. It never starts anything.</source>
        <translation>Lever un arrêt ou un défaut verrouillé. Ne démarre jamais rien.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Consignes</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>What is held in front of the source: outlines, materials, mounting</source>
        <translation>Ce qui est tenu devant la source&#xa0;: contours, matériaux, montage</translation>
    </message>
    <message>
        <source>What temperature each object shall have, and whether it can be reached</source>
        <translation>La température que chaque objet doit avoir, et si elle peut être atteinte</translation>
    </message>
    <message>
        <source>Temperatures, the scene and the controller during a run</source>
        <translation>Températures, scène et régulateur pendant un essai</translation>
    </message>
    <message>
        <source>A recorded run, opened again</source>
        <translation>Un essai enregistré, rouvert</translation>
    </message>
    <message>
        <source>Temperature &amp;unit</source>
        <translation>&amp;Unité de température</translation>
    </message>
    <message>
        <source>Degrees Celsius (°C)</source>
        <translation>Degrés Celsius (°C)</translation>
    </message>
    <message>
        <source>Kelvin (K)</source>
        <translation>Kelvins (K)</translation>
    </message>
    <message>
        <source>Degrees Fahrenheit (°F)</source>
        <translation>Degrés Fahrenheit (°F)</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Thème</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Comme le bureau</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>The camera: its lens, where it stands, and where the source is</source>
        <translation>La caméra : son objectif, sa place, et celle de la source</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>The devices, what must be so before a run, and the robot and the heat by hand</source>
        <translation>Les appareils, ce qui doit être en ordre avant un essai, le robot et le chauffage à la main</translation>
    </message>
    <message>
        <source>Ac&amp;knowledge all alarms</source>
        <translation>A&amp;cquitter toutes les alarmes</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list. (F9)</source>
        <translation>Vous avez vu toutes les alarmes. Celles qui sont terminées quittent la liste. (F9)</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>&amp;Vider la liste</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>Report a &amp;problem…</source>
        <translation>Signaler un &amp;problème…</translation>
    </message>
    <message>
        <source>The &amp;first five minutes</source>
        <translation>Les &amp;cinq premières minutes</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>Taille du te&amp;xte</translation>
    </message>
    <message>
        <source>&amp;Retreat…</source>
        <translation>Re&amp;trait…</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source and the heat goes off, in every state in which the robot answers. A fault stays latched.</source>
        <translation>Le robot éloigne les objets de la source et le chauffage est coupé, dans tout état où le robot répond. Un défaut reste verrouillé.</translation>
    </message>
    <message>
        <source>End the re&amp;cording</source>
        <translation>Clore l’&amp;enregistrement</translation>
    </message>
    <message>
        <source>After a stop or a fault the recording goes on until everything is cold. This ends it now.</source>
        <translation>Après un arrêt ou un défaut, l’enregistrement continue jusqu’à ce que tout soit froid. Ceci le termine maintenant.</translation>
    </message>
    <message>
        <source>Alarm &amp;horn</source>
        <translation>A&amp;vertisseur d’alarme</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Désactivé</translation>
    </message>
    <message>
        <source>On a real rig</source>
        <translation>Sur un banc réel</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Toujours</translation>
    </message>
    <message>
        <source>The desktop&apos;s bell, until alarms of priority 1 and 2 are acknowledged or over; once for priority 3</source>
        <translation>Le signal sonore du bureau, jusqu’à ce que les alarmes de priorité 1 et 2 soient acquittées ou passées ; une fois pour la priorité 3</translation>
    </message>
    <message>
        <source>&amp;Operator and sample…</source>
        <translation>&amp;Opérateur et échantillon…</translation>
    </message>
    <message>
        <source>Who operates, and what is heated: recordings, reports and the list of runs show it.</source>
        <translation>Qui opère, et ce qui est chauffé&#xa0;: les enregistrements, les rapports et la liste des essais le montrent.</translation>
    </message>
    <message>
        <source>&amp;Monitoring…</source>
        <translation>&amp;Surveillance…</translation>
    </message>
    <message>
        <source>Large &amp;numbers</source>
        <translation>&amp;Grands nombres</translation>
    </message>
    <message>
        <source>Ho&amp;me the robot…</source>
        <translation>Prise d’ori&amp;gine du robot…</translation>
    </message>
    <message>
        <source>All &amp;alarms…</source>
        <translation>Toutes les alar&amp;mes…</translation>
    </message>
    <message>
        <source>The alarms of all recorded runs, with how often and when</source>
        <translation>Les alarmes de tous les essais enregistrés, avec leur nombre et leur date</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>Le robot cherche ses contacts pour connaître sa position : il bouge</translation>
    </message>
</context>
<context>
    <name>bask::AirForm</name>
    <message>
        <source>The simulated rig has natural convection.</source>
        <translation>Le banc simulé a une convection naturelle.</translation>
    </message>
    <message>
        <source>The simulated rig has h = %1 W/(m² K).</source>
        <translation>Le banc simulé a h = %1 W/(m² K).</translation>
    </message>
    <message>
        <source>Natural convection would take some %1 % of what “%2” loses at %3.</source>
        <translation>Une convection naturelle prendrait environ %1 % de ce que « %2 » perd à %3.</translation>
    </message>
    <message>
        <source>Takes %1 % of what “%2” loses at %3, with h = %4 W/(m² K).</source>
        <translation>Prend %1 % de ce que « %2 » perd à %3, avec h = %4 W/(m² K).</translation>
    </message>
    <message>
        <source>Air in the room</source>
        <translation>Air de la pièce</translation>
    </message>
    <message>
        <source>Convection, for all objects</source>
        <translation>Convection, pour tous les objets</translation>
    </message>
    <message>
        <source>What verdicts, predictions and controllers take the air to be; it has the temperature of the room</source>
        <translation>Ce que les verdicts, les prévisions et les régulateurs supposent de l’air ; il a la température de la pièce</translation>
    </message>
    <message>
        <source>not known, not counted</source>
        <translation>inconnue, non comptée</translation>
    </message>
    <message>
        <source>h is given</source>
        <translation>h est donné</translation>
    </message>
    <message>
        <source>natural, by correlation</source>
        <translation>naturelle, par corrélation</translation>
    </message>
</context>
<context>
    <name>bask::AlarmButton</name>
    <message>
        <source>Alarm of priority %1 (%2): %3</source>
        <translation>Alarme de priorité %1 (%2) : %3</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>%1 de plus.</translation>
    </message>
    <message>
        <source>This may be old: the engine is not answering.</source>
        <translation>C’est peut-être périmé : le moteur ne répond pas.</translation>
    </message>
</context>
<context>
    <name>bask::AlarmHistoryDialog</name>
    <message>
        <source>Priority %1: %2</source>
        <translation>Priorité %1 : %2</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>RÉEL</translation>
    </message>
    <message>
        <source>Reading the runs: %1 %</source>
        <translation>Lecture des essais : %1 %</translation>
    </message>
    <message>
        <source>The list has no run.</source>
        <translation>La liste n’a aucun essai.</translation>
    </message>
    <message numerus="yes">
        <source>No alarm was raised in %n run(s).</source>
        <translation>
            <numerusform>Aucune alarme n’est apparue dans %n essai.</numerusform>
            <numerusform>Aucune alarme n’est apparue dans %n essais.</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm matches &quot;%1&quot;.</source>
        <translation>Aucune alarme ne correspond à « %1 ».</translation>
    </message>
    <message numerus="yes">
        <source>Alarms in %1 of %n run(s)</source>
        <translation>
            <numerusform>Alarmes dans %1 essai sur %n</numerusform>
            <numerusform>Alarmes dans %1 essais sur %n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read: %1</source>
        <translation>
            <numerusform>%n enregistrement n’a pas pu être lu : %1</numerusform>
            <numerusform>%n enregistrements n’ont pas pu être lus : %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Alarms of the listed runs</source>
        <translation>Alarmes des essais listés</translation>
    </message>
    <message>
        <source>Filter the alarms</source>
        <translation>Filtrer les alarmes</translation>
    </message>
    <message>
        <source>Shows the alarms that have every word.</source>
        <translation>Montre les alarmes qui ont tous les mots.</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>Last raised</source>
        <translation>Dernière fois</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>Dernier essai</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>As it was raised the last time</source>
        <translation>Telle qu’elle est apparue la dernière fois</translation>
    </message>
    <message>
        <source>Number of runs in which it was raised</source>
        <translation>Nombre d’essais où elle est apparue</translation>
    </message>
    <message>
        <source>How often it was raised</source>
        <translation>Combien de fois elle est apparue</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>Raised at</source>
        <translation>Apparue à</translation>
    </message>
    <message>
        <source>Runs of the selected alarm</source>
        <translation>Essais de l’alarme choisie</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>Temps depuis le démarrage</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the alarms as text, for a spreadsheet</source>
        <translation>Copier les alarmes comme texte, pour un tableur</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>Ouvrir l’essai choisi</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>%1. Only %2 of %3 alarms are shown, the gravest.</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>%1. Seules %2 des %3 alarmes sont montrées, les plus graves.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a run: its name, and when it was recorded</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>1 is the gravest</source>
        <translation>1 est la plus grave</translation>
    </message>
    <message>
        <source>Opens the run at the moment when the alarm was last raised in it</source>
        <translation>Ouvre l’essai au moment où l’alarme y est apparue la dernière fois</translation>
    </message>
    <message>
        <source>%1 + %2</source>
        <comment>when a run was recorded, and the time in it</comment>
        <translation>%1 + %2</translation>
    </message>
    <message>
        <source>When the last run with it was recorded, and the time since Start when it was raised</source>
        <translation>Quand le dernier essai où elle est apparue a été enregistré, et le temps depuis Démarrer où elle est apparue</translation>
    </message>
    <message>
        <source>No run</source>
        <translation>Aucun essai</translation>
    </message>
    <message>
        <source>Raised while nothing was recorded</source>
        <translation>Apparue alors que rien n’était enregistré</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n time(s) while nothing was recorded</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>
            <numerusform>%1, et %n fois alors que rien n’était enregistré</numerusform>
            <numerusform>%1, et %n fois alors que rien n’était enregistré</numerusform>
        </translation>
    </message>
    <message>
        <source>The alarms that were raised while nothing was recorded could not be read.</source>
        <translation>Les alarmes apparues alors que rien n’était enregistré n’ont pas pu être lues.</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) with alarms that were raised while nothing was recorded could not be read.</source>
        <translation>
            <numerusform>%n ligne d’alarmes apparues alors que rien n’était enregistré n’a pas pu être lue.</numerusform>
            <numerusform>%n lignes d’alarmes apparues alors que rien n’était enregistré n’ont pas pu être lues.</numerusform>
        </translation>
    </message>
    <message>
        <source>Without a run, when the alarm was raised</source>
        <translation>Sans essai : quand l’alarme est apparue</translation>
    </message>
    <message>
        <source>at least %1</source>
        <comment>a duration: minutes and seconds</comment>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>Time for which it was active, until it was over or reset. &quot;At least&quot;: a recording ended before it, or the end of one of its times is not known.</source>
        <translation>Temps pendant lequel elle a été active, jusqu’à ce qu’elle soit finie ou réinitialisée. « Au moins » : un enregistrement s’est terminé avant elle, ou la fin d’une de ses fois n’est pas connue.</translation>
    </message>
</context>
<context>
    <name>bask::AlarmList</name>
    <message>
        <source>Priority %1</source>
        <translation>Priorité %1</translation>
    </message>
    <message>
        <source>Priority %1. %2.</source>
        <translation>Priorité %1. %2.</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>No alarms.</source>
        <translation>Aucune alarme.</translation>
    </message>
    <message>
        <source>Choose an alarm to read what to do.</source>
        <translation>Choisissez une alarme pour lire ce qu’il faut faire.</translation>
    </message>
    <message>
        <source>Raised at %1, %2 times since it was last acknowledged.</source>
        <translation>Apparue à %1, %2 fois depuis le dernier acquittement.</translation>
    </message>
    <message>
        <source>Raised at %1.</source>
        <translation>Apparue à %1.</translation>
    </message>
    <message>
        <source>Over at %1.</source>
        <translation>Terminée à %1.</translation>
    </message>
    <message>
        <source>The first of those that came together: likely their cause.</source>
        <translation>La première de celles apparues ensemble : sans doute leur cause.</translation>
    </message>
    <message>
        <source>It was active when Bask was last left.</source>
        <translation>Elle était active quand Bask a été quitté.</translation>
    </message>
    <message>
        <source>The engine is not answering: these alarms may be old.</source>
        <translation>Le moteur ne répond pas : ces alarmes sont peut-être périmées.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorité</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>Apparue</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Fois</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>What to do about the alarm</source>
        <translation>Que faire pour cette alarme</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>You have seen this alarm. It stays in the list while its condition holds.</source>
        <translation>Vous avez vu cette alarme. Elle reste dans la liste tant que sa condition dure.</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Tout acquitter</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list.</source>
        <translation>Vous avez vu toutes les alarmes. Celles qui sont terminées quittent la liste.</translation>
    </message>
    <message>
        <source>Shelved: %1</source>
        <translation>Mises de côté : %1</translation>
    </message>
    <message numerus="yes">
        <source>, %n follow(s)</source>
        <comment>from this alarm</comment>
        <translation>
            <numerusform>, %n en découle</numerusform>
            <numerusform>, %n en découlent</numerusform>
        </translation>
    </message>
    <message>
        <source>It follows from the alarm over it, and goes with that.</source>
        <translation>Elle découle de l’alarme au-dessus et disparaît avec elle.</translation>
    </message>
    <message>
        <source>Take the alarm back from the shelf</source>
        <translation>Reprendre l’alarme mise de côté</translation>
    </message>
    <message>
        <source>Shelve: put the alarm aside for a time, with a reason</source>
        <translation>Mettre l’alarme de côté pour un temps, avec une raison</translation>
    </message>
    <message>
        <source>All alarms…</source>
        <translation>Toutes les alarmes…</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Shelve…</source>
        <translation>Mettre de côté…</translation>
    </message>
</context>
<context>
    <name>bask::AlarmWords</name>
    <message>
        <source>Active</source>
        <translation>Active</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>Terminée</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nouvelle</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vue</translation>
    </message>
    <message>
        <source>first</source>
        <translation>première</translation>
    </message>
    <message>
        <source>from before</source>
        <translation>d’avant</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between states</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Shelved until %1: %2</source>
        <translation>De côté jusqu’à %1 : %2</translation>
    </message>
    <message>
        <source>seen by %1</source>
        <translation>vue par %1</translation>
    </message>
    <message>
        <source>Shelved until %1 by %3: %2</source>
        <translation>Mise de côté jusqu’à %1 par %3&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>bask::AxisTable</name>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Where the axis reads zero</source>
        <translation>Là où l’axe indique zéro</translation>
    </message>
    <message>
        <source>Axis that drives %1</source>
        <translation>Axe qui entraîne %1</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>inversé</translation>
    </message>
    <message>
        <source>The axis of %1 counts the other way</source>
        <translation>L’axe de %1 compte dans l’autre sens</translation>
    </message>
    <message>
        <source>%1 where its axis reads zero</source>
        <translation>%1 là où son axe indique zéro</translation>
    </message>
</context>
<context>
    <name>bask::BeliefText</name>
    <message>
        <source>The controller begins with heat rates wrong by up to ×%1, as the experiment asks.</source>
        <translation>Le régulateur commence avec des coefficients thermiques faux d’un facteur allant jusqu’à %1, comme le demande l’expérience.</translation>
    </message>
</context>
<context>
    <name>bask::BoardForm</name>
    <message>
        <source>&amp;Board</source>
        <translation>&amp;Mire</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>&amp;Dictionnaire</translation>
    </message>
    <message>
        <source>As measured on the print: over ten squares, divided by ten.</source>
        <translation>Tel que mesuré sur l’impression : sur dix cases, divisé par dix.</translation>
    </message>
    <message>
        <source>Boards made by OpenCV before 4.6 with an even number of rows.</source>
        <translation>Mires faites par OpenCV avant 4.6 avec un nombre pair de rangées.</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>Mire ChArUco</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Échiquier</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>Dictionnaire des marqueurs</translation>
    </message>
    <message>
        <source>Inner cor&amp;ners</source>
        <translation>Coi&amp;ns intérieurs</translation>
    </message>
    <message>
        <source>Inner corners across</source>
        <translation>Coins intérieurs en largeur</translation>
    </message>
    <message>
        <source>Inner corners down</source>
        <translation>Coins intérieurs en hauteur</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>Type de mire</translation>
    </message>
    <message>
        <source>Lower left square is black</source>
        <translation>La case en bas à gauche est noire</translation>
    </message>
    <message>
        <source>S&amp;ide of a square</source>
        <translation>Côté d’une ca&amp;se</translation>
    </message>
    <message>
        <source>S&amp;quares</source>
        <translation>Cas&amp;es</translation>
    </message>
    <message>
        <source>Side of a &amp;marker</source>
        <translation>Côté d’un ma&amp;rqueur</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>Côté d’un marqueur</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>Côté d’une case</translation>
    </message>
    <message>
        <source>Squares across</source>
        <translation>Cases en largeur</translation>
    </message>
    <message>
        <source>Squares down</source>
        <translation>Cases en hauteur</translation>
    </message>
    <message>
        <source>With its black border, as measured on the print.</source>
        <translation>Avec sa bordure noire, tel que mesuré sur l’impression.</translation>
    </message>
</context>
<context>
    <name>bask::BottomDock</name>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>Alarmes (%1)</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Alarms and events</source>
        <translation>Alarmes et événements</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>, %1 shelved</source>
        <comment>behind the number of alarms</comment>
        <translation>, %1 de côté</translation>
    </message>
</context>
<context>
    <name>bask::CalibratePage</name>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>What is calibrated</source>
        <translation>Ce qui est étalonné</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Simulated camera</source>
        <translation>Caméra simulée</translation>
    </message>
    <message>
        <source>Or type a number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…), and Enter</source>
        <translation>Ou tapez un numéro (0), un périphérique (/dev/video0), un fichier vidéo, un dossier d’images ou une adresse (rtsp://…), puis Entrée</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>Caméra thermique</translation>
    </message>
</context>
<context>
    <name>bask::CalibrationAge</name>
    <message>
        <source>at an unknown time</source>
        <translation>à une date inconnue</translation>
    </message>
    <message>
        <source>in the future: check the computer&apos;s clock</source>
        <translation>dans le futur : vérifiez l’horloge de l’ordinateur</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>à l’instant</translation>
    </message>
    <message>
        <source>Camera calibrated %1.</source>
        <translation>Caméra étalonnée %1.</translation>
    </message>
    <message>
        <source>Camera not calibrated.</source>
        <translation>Caméra non étalonnée.</translation>
    </message>
    <message>
        <source>Where the camera stands was measured %1.</source>
        <translation>La place de la caméra a été mesurée %1.</translation>
    </message>
    <message>
        <source>Where the camera stands is not measured.</source>
        <translation>La place de la caméra n’est pas mesurée.</translation>
    </message>
    <message>
        <source>The source&apos;s place is as typed, not measured by the camera.</source>
        <translation>La place de la source est celle saisie, non mesurée par la caméra.</translation>
    </message>
    <message>
        <source>The source&apos;s place was measured %1.</source>
        <translation>La place de la source a été mesurée %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>il y a %n minute</numerusform>
            <numerusform>il y a %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>il y a %n heure</numerusform>
            <numerusform>il y a %n heures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>il y a %n jour</numerusform>
            <numerusform>il y a %n jours</numerusform>
        </translation>
    </message>
    <message>
        <source>Thermal camera&apos;s lens calibrated %1.</source>
        <translation>Objectif de la caméra thermique étalonné %1.</translation>
    </message>
    <message>
        <source>Thermal camera&apos;s lens not calibrated.</source>
        <translation>Objectif de la caméra thermique non étalonné.</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is not known.</source>
        <translation>La place de la caméra thermique n’est pas connue.</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is as typed, not measured.</source>
        <translation>La place de la caméra thermique est telle que saisie, non mesurée.</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place was measured %1.</source>
        <translation>La place de la caméra thermique a été mesurée %1.</translation>
    </message>
</context>
<context>
    <name>bask::CameraPanel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>É&amp;talonner</translation>
    </message>
    <message>
        <source>&amp;Start looking</source>
        <translation>&amp;Chercher</translation>
    </message>
    <message>
        <source>&amp;Stop looking</source>
        <translation>Arrêter de &amp;chercher</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>Mire d’étalonnage</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>Étalonnage de la caméra</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Cameras (%1);;All files (*)</source>
        <translation>Caméras (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Drops all views. The board can be set again.</source>
        <translation>Abandonne toutes les vues. La mire peut de nouveau être réglée.</translation>
    </message>
    <message>
        <source>Hold the board still.</source>
        <translation>Tenez la mire immobile.</translation>
    </message>
    <message>
        <source>Leave &amp;out the views that stand out</source>
        <translation>Écarter les vues qui se d&amp;istinguent</translation>
    </message>
    <message>
        <source>Load a camera</source>
        <translation>Charger une caméra</translation>
    </message>
    <message>
        <source>Looks for the board in the live picture.</source>
        <translation>Cherche la mire dans l’image en direct.</translation>
    </message>
    <message>
        <source>OpenCV YAML (%1)</source>
        <translation>YAML d’OpenCV (%1)</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>Avancement de l’étalonnage</translation>
    </message>
    <message>
        <source>ROS camera_info (%1)</source>
        <translation>camera_info de ROS (%1)</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>Enregistrer la caméra</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Start looking, then show the board to the camera from near and far, at all edges of the picture and tilted to all sides.</source>
        <translation>Lancez la recherche, puis montrez la mire à la caméra de près et de loin, à tous les bords de l’image et inclinée de tous les côtés.</translation>
    </message>
    <message>
        <source>Ta&amp;ke this view</source>
        <translation>&amp;Prendre cette vue</translation>
    </message>
    <message>
        <source>Take still, new views &amp;automatically</source>
        <translation>Prendre seul les vues nouvelles et immo&amp;biles</translation>
    </message>
    <message>
        <source>The board is seen: hold it still and take the view.</source>
        <translation>La mire est vue : tenez-la immobile et prenez la vue.</translation>
    </message>
    <message>
        <source>The camera is saved in %1.</source>
        <translation>La caméra est enregistrée dans %1.</translation>
    </message>
    <message>
        <source>The views are of this board: start again to set another.</source>
        <translation>Les vues sont de cette mire : recommencez pour en régler une autre.</translation>
    </message>
    <message>
        <source>There is such a view: move the board on.</source>
        <translation>Cette vue existe déjà : déplacez la mire.</translation>
    </message>
    <message>
        <source>Too little of the board is seen for a view.</source>
        <translation>La mire est trop peu visible pour une vue.</translation>
    </message>
    <message>
        <source>Use the board seen</source>
        <translation>Prendre la mire vue</translation>
    </message>
    <message>
        <source>View %1 is taken: move the board on.</source>
        <translation>La vue %1 est prise : déplacez la mire.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Vues</translation>
    </message>
    <message>
        <source>Waiting for the camera&apos;s pictures.</source>
        <translation>En attente des images de la caméra.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>bask::CameraResult</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 vues</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>%1, in use</source>
        <translation>%1, en service</translation>
    </message>
    <message>
        <source>&amp;Use this camera</source>
        <translation>&amp;Utiliser cette caméra</translation>
    </message>
    <message>
        <source>Calibrate it by views of a board, or load its file.</source>
        <translation>Étalonnez-la par des vues d’une mire, ou chargez son fichier.</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Bon</translation>
    </message>
    <message>
        <source>Load a camera from a file</source>
        <translation>Charger une caméra depuis un fichier</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Charger…</translation>
    </message>
    <message>
        <source>No camera yet</source>
        <translation>Pas encore de caméra</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Paramètre</translation>
    </message>
    <message>
        <source>Parameters of the camera</source>
        <translation>Paramètres de la caméra</translation>
    </message>
    <message>
        <source>Poses of markers are computed by it from now on.</source>
        <translation>Les poses des marqueurs sont désormais calculées par elle.</translation>
    </message>
    <message>
        <source>Read from a file: how far it holds was not checked here.</source>
        <translation>Lue dans un fichier : sa justesse n’a pas été vérifiée ici.</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>À refaire</translation>
    </message>
    <message>
        <source>Save the camera in a file</source>
        <translation>Enregistrer la caméra dans un fichier</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Écart type</translation>
    </message>
    <message>
        <source>The camera in use</source>
        <translation>La caméra en service</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>Utilisable</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>held-out views %1 px</source>
        <translation>vues mises de côté %1 px</translation>
    </message>
    <message>
        <source>residual %1 px</source>
        <translation>résidu %1 px</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>bask::CheckList</name>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>en défaut</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>pas encore</translation>
    </message>
    <message>
        <source>Before a run</source>
        <translation>Avant un essai</translation>
    </message>
    <message>
        <source>Devices: simulated</source>
        <translation>Appareils : simulés</translation>
    </message>
    <message>
        <source>Devices: none set up as %1</source>
        <translation>Appareils : aucun réglé pour %1</translation>
    </message>
    <message>
        <source>Devices: no answer from %1</source>
        <translation>Appareils : pas de réponse de %1</translation>
    </message>
    <message>
        <source>Devices: all answer</source>
        <translation>Appareils : tous répondent</translation>
    </message>
    <message>
        <source>Robot: in alarm</source>
        <translation>Robot : en alarme</translation>
    </message>
    <message>
        <source>Robot: its place is not sure</source>
        <translation>Robot : sa position n’est pas sûre</translation>
    </message>
    <message>
        <source>Robot: its place is sure</source>
        <translation>Robot : sa position est sûre</translation>
    </message>
    <message>
        <source>Sensors: no readings yet</source>
        <translation>Capteurs : pas encore de mesures</translation>
    </message>
    <message>
        <source>Sensors: the newest readings are %1 old</source>
        <translation>Capteurs : les dernières mesures datent de %1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 without a valid reading</source>
        <translation>Capteurs : %1 sur %2 sans mesure valable</translation>
    </message>
    <message>
        <source>Sensors: fresh and valid</source>
        <translation>Capteurs : mesures récentes et valables</translation>
    </message>
    <message>
        <source>Source: no temperature</source>
        <translation>Source : pas de température</translation>
    </message>
    <message>
        <source>Source: warm, %1</source>
        <translation>Source : chaude, %1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet</source>
        <translation>Source : %1, pas encore à %2</translation>
    </message>
    <message>
        <source>Source: %1, above %2</source>
        <translation>Source : %1, au-dessus de %2</translation>
    </message>
    <message>
        <source>Recording: not possible</source>
        <translation>Enregistrement : impossible</translation>
    </message>
    <message>
        <source>Recording: begins with Arm</source>
        <translation>Enregistrement : commence avec Armer</translation>
    </message>
    <message>
        <source>Recording: on</source>
        <translation>Enregistrement : en cours</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Robot: its place is UNKNOWN, what it told last is %1</source>
        <translation>Robot : position INCONNUE, ce qu’il a dit en dernier : %1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 not believed</source>
        <translation>Capteurs : %1 sur %2 non crus</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 stale</source>
        <translation>Capteurs : %1 sur %2 périmés</translation>
    </message>
    <message>
        <source>Source: UNKNOWN whether it heats, %1</source>
        <translation>Source : INCONNU si elle chauffe, %1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet. %3</source>
        <extracomment>the last is a sentence about the time that it takes</extracomment>
        <translation>Source&#xa0;: %1, pas encore à %2. %3</translation>
    </message>
    <message>
        <source>Source: it heats though its heat is off, %1</source>
        <translation>Source : elle chauffe quoique son chauffage soit coupé, %1</translation>
    </message>
</context>
<context>
    <name>bask::Coach</name>
    <message>
        <source>Show me</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Pas maintenant</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>number of the step, of so many, what to do</extracomment>
        <translation>%1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>Montrer où</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>On the Objects page, select “bunny” and drag Harmonics. With fewer of them its outline leaves the drawing&apos;s.</source>
        <translation>Page Objets : choisissez « bunny » et faites glisser les harmoniques. Moins il y en a, plus le contour s’écarte du dessin.</translation>
    </message>
    <message>
        <source>Take that back with Ctrl+Z. Every edit can be undone.</source>
        <translation>Annulez avec Ctrl+Z. Toute modification peut être annulée.</translation>
    </message>
    <message>
        <source>On the Targets page, type %1 for one object and read why it cannot be held.</source>
        <translation>Page Consignes : tapez %1 pour un objet et lisez pourquoi cela ne peut être tenu.</translation>
    </message>
    <message>
        <source>Press “Use nearest feasible”: targets that can be held together.</source>
        <translation>Appuyez sur « Prendre les plus proches » : des consignes tenables ensemble.</translation>
    </message>
    <message>
        <source>Start (F6): the heat is on, and the robot moves.</source>
        <translation>Démarrer (F6) : le chauffage est en marche et le robot bouge.</translation>
    </message>
    <message>
        <source>The run has ended in a fault, as a hold that lasts does. End it in Tools &gt; Simulate fault, press Reset, then Arm (F5) and Start (F6) again.</source>
        <translation>L’essai s’est terminé en défaut, comme toute pause qui dure. Levez le défaut dans Outils &gt; Simuler un défaut, pressez Réinitialiser, puis de nouveau Armer (F5) et Démarrer (F6).</translation>
    </message>
    <message>
        <source>The run has ended. Arm (F5) and Start (F6) again.</source>
        <translation>L’essai est terminé. De nouveau, Armer (F5) et Démarrer (F6).</translation>
    </message>
    <message>
        <source>The run has ended. End the fault in Tools &gt; Simulate fault, then Arm (F5) and Start (F6) again.</source>
        <translation>L’essai est terminé. Levez le défaut dans Outils &gt; Simuler un défaut, puis de nouveau Armer (F5) et Démarrer (F6).</translation>
    </message>
    <message>
        <source>The temperatures go to their targets. Press N on the Run page and note something.</source>
        <translation>Les températures vont à leurs consignes. Sur la page Essai, appuyez sur N et notez quelque chose.</translation>
    </message>
    <message>
        <source>Change a gain at the controller and apply it: the traces are marked there.</source>
        <translation>Changez un gain du régulateur et appliquez-le : les courbes en gardent la marque.</translation>
    </message>
    <message>
        <source>Acknowledge the alarm (F9): you have seen it.</source>
        <translation>Acquittez l’alarme (F9) : vous l’avez vue.</translation>
    </message>
    <message>
        <source>Stop (F8): heat off, the robot retreats, the recording is closed.</source>
        <translation>Arrêter (F8) : chauffage coupé, le robot se retire, l’enregistrement est fermé.</translation>
    </message>
    <message>
        <source>On the Review page, open the recording of this run.</source>
        <translation>Page Relecture : ouvrez l’enregistrement de cet essai.</translation>
    </message>
    <message>
        <source>Type %1 there again, which is reached sooner. Then Arm (F5): the sensors are zeroed and the recording is opened. Nothing moves yet.</source>
        <translation>Retapez-y %1, atteint plus vite. Puis armez (F5) : les capteurs sont ajustés et l’enregistrement est ouvert. Rien ne bouge encore.</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; thermal-camera: three objects that only a thermal camera reads. On the Run page, look at the tab Thermal picture.</source>
        <translation>Fichier &gt; Exemples &gt; thermal-camera&#xa0;: trois objets que seule une caméra thermique lit. Sur la page Essai, regardez l’onglet Image thermique.</translation>
    </message>
    <message>
        <source>That was all. “Simulated rig” on the Rig page leads back to the simulated one; F1 opens the manual, which has the rest.</source>
        <translation>C’est tout. «&#xa0;Banc simulé&#xa0;», page Banc, ramène au banc simulé&#xa0;; F1 ouvre le manuel, où se trouve le reste.</translation>
    </message>
    <message>
        <source>New here? %1 small steps on simulated rigs show what Bask does. Nothing can burn.</source>
        <extracomment>how many</extracomment>
        <translation>Première fois&#xa0;? %1 petites étapes sur des bancs simulés montrent ce que fait Bask. Rien ne peut brûler.</translation>
    </message>
    <message>
        <source>Tools &gt; Simulate fault &gt; %1: choose an object. The run holds, and an alarm says what to do.</source>
        <extracomment>a simulated fault, as the menu has it</extracomment>
        <translation>Outils &gt; Simuler un défaut &gt; %1&#xa0;: choisissez un objet. L’essai se met en pause et une alarme dit que faire.</translation>
    </message>
    <message>
        <source>Remove its cause: choose the fault again in the same menu, which ends it. The sensor tells its temperature again.</source>
        <translation>Supprimez sa cause&#xa0;: choisissez de nouveau le défaut dans le même menu, ce qui y met fin. Le capteur redonne sa température.</translation>
    </message>
    <message>
        <source>Resume (Shift+F7): the run goes on where it was held.</source>
        <translation>Reprendre (Maj+F7)&#xa0;: l’essai continue là où il était en pause.</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; serial-rig: a rig with devices of its own, as a real one has. They are at serial ports, where nothing answers yet.</source>
        <translation>Fichier &gt; Exemples &gt; serial-rig&#xa0;: un banc qui a ses propres appareils, comme un banc réel. Ils sont sur des ports série, où rien ne répond encore.</translation>
    </message>
    <message>
        <source>Type “bask simulate-rig” in a terminal: it plays robot, thermometer and heat source at these ports. On the Rig page all three become live.</source>
        <translation>Tapez «&#xa0;bask simulate-rig&#xa0;» dans un terminal&#xa0;: il joue le robot, le thermomètre et la source de chaleur sur ces ports. Page Banc, tous trois deviennent actifs.</translation>
    </message>
    <message>
        <source>Find a device: “Remove” the thermometer, then “Set up…” with port %1. “Find devices” lists what answers there; choose it and press “Use”.</source>
        <extracomment>the path of a serial port</extracomment>
        <translation>Trouvez un appareil&#xa0;: «&#xa0;Retirer&#xa0;» le thermomètre, puis «&#xa0;Régler…&#xa0;» avec le port %1. «&#xa0;Chercher les appareils&#xa0;» liste ce qui y répond&#xa0;; choisissez-le et pressez «&#xa0;Utiliser&#xa0;».</translation>
    </message>
</context>
<context>
    <name>bask::Comparison</name>
    <message>
        <source>Metric</source>
        <translation>Indicateur</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>object; its steps in the runs</comment>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>bask::ComparisonView</name>
    <message>
        <source>Differences from</source>
        <translation>Différences avec</translation>
    </message>
    <message>
        <source>The run that the others are compared with</source>
        <translation>L’essai auquel les autres sont comparés</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the table as text, for a spreadsheet or a letter</source>
        <translation>Copier le tableau comme texte, pour un tableur ou une lettre</translation>
    </message>
    <message>
        <source>Export (CSV)…</source>
        <translation>Exporter (CSV)…</translation>
    </message>
    <message>
        <source>Metrics of the runs that are laid over each other</source>
        <translation>Indicateurs des essais superposés</translation>
    </message>
    <message>
        <source>%1 less %2</source>
        <translation>%1 moins %2</translation>
    </message>
    <message>
        <source>Being computed from all samples: %1</source>
        <translation>Calcul en cours sur tous les échantillons&#xa0;: %1</translation>
    </message>
    <message>
        <source>No metrics, the recording cannot be read to its end: %1</source>
        <translation>Pas d’indicateurs, l’enregistrement ne peut pas être lu jusqu’à la fin&#xa0;: %1</translation>
    </message>
    <message>
        <source>Write the numbers of this table for other programs</source>
        <translation>Écrire les nombres de ce tableau pour d’autres programmes</translation>
    </message>
    <message>
        <source>Once all metrics are computed</source>
        <translation>Une fois tous les indicateurs calculés</translation>
    </message>
    <message numerus="yes">
        <source>Copied %n row(s)</source>
        <translation>
            <numerusform>%n ligne copiée</numerusform>
            <numerusform>%n lignes copiées</numerusform>
        </translation>
    </message>
    <message>
        <source>The steps are not alike, so neither are times and overshoots: %1</source>
        <translation>Les échelons diffèrent ; temps et dépassements ne se comparent donc pas : %1</translation>
    </message>
    <message>
        <source>The source was not equally hot at Start: %1</source>
        <translation>La source n’était pas également chaude au départ : %1</translation>
    </message>
</context>
<context>
    <name>bask::ControllerPanel</name>
    <message>
        <source>Not applied: %1</source>
        <comment>number of changes</comment>
        <translation>Non appliqué&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Controller and gains</source>
        <translation>Régulateur et gains</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Régulateur</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Use these settings from the next control step on; noted in the run&apos;s log.</source>
        <translation>Utiliser ces réglages dès le prochain pas de commande&#xa0;; noté dans le journal de l’essai.</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Back to the settings in use.</source>
        <translation>Revenir aux réglages en service.</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: it never settles.</source>
        <translation>Après un échelon de %1 K, sans limites ni bruit : ne se stabilise jamais.</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: overshoot %2 %, within ±%3 K after %4 s.</source>
        <translation>Après un échelon de %1 K, sans limites ni bruit : dépassement %2 %, à ±%3 K près après %4 s.</translation>
    </message>
    <message>
        <source>After a step of %1 K, once it has adapted, without limits and noise: no overshoot, within ±%2 K after %3 s at best.</source>
        <translation>Après un échelon de %1 K, une fois adapté, sans limites ni bruit : aucun dépassement, à ±%2 K près après %3 s au mieux.</translation>
    </message>
    <message>
        <source>Frequency ω</source>
        <translation>Pulsation ω</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>Natural frequency: ω = √K. Changes D and K together.</source>
        <translation>Pulsation propre : ω = √K. Modifie D et K ensemble.</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>Taux d’amortissement ζ</translation>
    </message>
    <message>
        <source>ζ = D / (2√K): overshoots below 1. Changes D.</source>
        <translation>ζ = D / (2√K) : dépassement au-dessous de 1. Modifie D.</translation>
    </message>
    <message>
        <source>Rates wrong: ×%1</source>
        <comment>the heat rates that the controller begins with</comment>
        <translation>Coefficients faux : ×%1</translation>
    </message>
</context>
<context>
    <name>bask::CountdownBar</name>
    <message>
        <source>In %1 s, unless the cause is gone: %2</source>
        <translation>Dans %1 s, sauf si la cause disparaît : %2</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>Cause : %1</translation>
    </message>
</context>
<context>
    <name>bask::CoverageView</name>
    <message>
        <source>%1 of %2 views</source>
        <translation>%1 vues sur %2</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 vues</translation>
    </message>
    <message>
        <source>Colours the picture by how many corners were seen where.</source>
        <translation>Colore l’image selon le nombre de coins vus à chaque endroit.</translation>
    </message>
    <message>
        <source>Covered: %1</source>
        <translation>Couvert : %1</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>De gauche à droite</translation>
    </message>
    <message>
        <source>Nearness</source>
        <translation>Proximité</translation>
    </message>
    <message>
        <source>Show on the &amp;picture</source>
        <translation>Montrer sur l’ima&amp;ge</translation>
    </message>
    <message>
        <source>This is enough: calibrate.</source>
        <translation>Cela suffit : étalonnez.</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Top to bottom</source>
        <translation>De haut en bas</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>bask::CutControls</name>
    <message>
        <source>No cut</source>
        <translation>Pas de coupe</translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>Coupe : %1</translation>
    </message>
    <message>
        <source>Object whose field is cut</source>
        <translation>Objet dont le champ est coupé</translation>
    </message>
    <message>
        <source>A plane in the colours of what one object would have there.</source>
        <translation>Un plan aux couleurs de ce qu’un objet y aurait.</translation>
    </message>
    <message>
        <source>What the cut shows: T, the steady temperature, or F, the view factor</source>
        <translation>Ce que montre la coupe : T, la température d’équilibre, ou F, le facteur de forme</translation>
    </message>
    <message>
        <source>T: the temperature that the object settles at there. F: its view factor.</source>
        <translation>T : la température où l’objet s’y stabilise. F : son facteur de forme.</translation>
    </message>
    <message>
        <source>Axis that the plane is square to</source>
        <translation>Axe perpendiculaire au plan</translation>
    </message>
    <message>
        <source>Place of the plane along its axis</source>
        <translation>Place du plan le long de son axe</translation>
    </message>
</context>
<context>
    <name>bask::CutOffRun</name>
    <message>
        <source>Bask ended in the middle of a run (%1) and could not stop the rig: look at the robot and the source before you go on.</source>
        <translation>Bask s’est arrêté au milieu d’un essai (%1) sans pouvoir arrêter le banc : examinez le robot et la source avant de continuer.</translation>
    </message>
    <message>
        <source>Bask ended in the middle of a simulated run (%1).</source>
        <translation>Bask s’est arrêté au milieu d’un essai simulé (%1).</translation>
    </message>
    <message>
        <source>Show in Review</source>
        <translation>Afficher dans Relecture</translation>
    </message>
    <message>
        <source>What it had recorded is kept.</source>
        <translation>Ce qui était enregistré est conservé.</translation>
    </message>
</context>
<context>
    <name>bask::DesktopFiles</name>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 n’est plus là.</translation>
    </message>
    <message>
        <source>The desktop has no program that opens %1.</source>
        <translation>Le bureau n’a pas de programme qui ouvre %1.</translation>
    </message>
</context>
<context>
    <name>bask::Device</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>Thermomètre</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>Source de chaleur</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Fermé</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>En ouverture</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Actif</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Perdu</translation>
    </message>
    <message>
        <source>Grbl or grblHAL (G-code)</source>
        <translation>Grbl ou grblHAL (G-code)</translation>
    </message>
    <message>
        <source>Dobot MG400 or M1 Pro (network)</source>
        <translation>Dobot MG400 ou M1 Pro (réseau)</translation>
    </message>
    <message>
        <source>Modbus RTU module</source>
        <translation>Module Modbus RTU</translation>
    </message>
    <message>
        <source>Lines of text (MAX31865)</source>
        <translation>Lignes de texte (MAX31865)</translation>
    </message>
    <message>
        <source>Kept hot by a person</source>
        <translation>Maintenue chaude par une personne</translation>
    </message>
    <message>
        <source>Hotplate (NAMUR, IKA)</source>
        <translation>Plaque chauffante (NAMUR, IKA)</translation>
    </message>
    <message>
        <source>Modbus RTU controller</source>
        <translation>Régulateur Modbus RTU</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a temperature and how old it is</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>Caméra thermique</translation>
    </message>
    <message>
        <source>Program of your own</source>
        <translation>Votre propre programme</translation>
    </message>
    <message>
        <source>Modbus TCP controller</source>
        <translation>Régulateur Modbus TCP</translation>
    </message>
    <message>
        <source>Modbus TCP module</source>
        <translation>Module Modbus TCP</translation>
    </message>
    <message>
        <source>heated by hand</source>
        <translation>chauffée à la main</translation>
    </message>
    <message>
        <source>heat off</source>
        <translation>sans chauffage</translation>
    </message>
    <message>
        <source>heat on</source>
        <translation>chauffage en marche</translation>
    </message>
    <message>
        <source>heat UNKNOWN</source>
        <translation>chauffage INCONNU</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>RÉEL</translation>
    </message>
    <message>
        <source>heats though off</source>
        <translation>chauffe malgré l’arrêt</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again: press Reset.</source>
        <translation>La position du robot n’était pas sûre. Elle l’est de nouveau : appuyez sur Réinitialiser.</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again.</source>
        <translation>La position du robot n’était pas sûre. Elle l’est de nouveau.</translation>
    </message>
</context>
<context>
    <name>bask::DeviceCard</name>
    <message>
        <source>Change…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Régler…</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulé</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>il y a %1</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Not in use yet</source>
        <translation>Pas encore utilisé</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) discarded</source>
        <translation>
            <numerusform>%n réponse écartée</numerusform>
            <numerusform>%n réponses écartées</numerusform>
        </translation>
    </message>
    <message>
        <source>Age of its newest answer, answers a second, and answers that nobody can read or that were not asked for</source>
        <translation>Âge de sa dernière réponse, réponses par seconde, et réponses illisibles ou non demandées</translation>
    </message>
    <message>
        <source>This is the one</source>
        <translation>C’est le bon</translation>
    </message>
    <message>
        <source>Use the device that answers now, and remember it instead of the one before</source>
        <translation>Utiliser l’appareil qui répond maintenant et le retenir à la place de l’ancien</translation>
    </message>
    <message>
        <source>Confirm…</source>
        <translation>Confirmer…</translation>
    </message>
    <message>
        <source>Look at what would be started, and allow it on this computer</source>
        <translation>Voir ce qui serait lancé, et l’autoriser sur cet ordinateur</translation>
    </message>
    <message>
        <source>The last of them: %1</source>
        <translation>La dernière : %1</translation>
    </message>
</context>
<context>
    <name>bask::DeviceConsole</name>
    <message>
        <source>Nothing is sent by hand while a run is armed or on, the heat is on or the robot moves.</source>
        <translation>Rien n’est envoyé à la main tant qu’un essai est armé ou en cours, que le chauffage est en marche ou que le robot bouge.</translation>
    </message>
    <message>
        <source>Bask sends this as it is and checks no limit: the robot can move and the source can heat. Bask lets the device go meanwhile, and takes it back 3 s later.</source>
        <translation>Bask envoie ceci tel quel et ne vérifie aucune limite&#xa0;: le robot peut bouger et la source peut chauffer. Bask lâche l’appareil pendant ce temps et le reprend 3 s plus tard.</translation>
    </message>
    <message>
        <source>No link to a device is open.</source>
        <translation>Aucune liaison avec un appareil n’est ouverte.</translation>
    </message>
    <message>
        <source>Device console</source>
        <translation>Console des appareils</translation>
    </message>
    <message>
        <source>All links</source>
        <translation>Toutes les liaisons</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>Les deux sens</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>Envoyé</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Reçu</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Show only rows with this text</source>
        <translation>N’afficher que les lignes avec ce texte</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The traffic of the last 10 minutes is kept meanwhile</source>
        <translation>Le trafic des 10 dernières minutes est conservé pendant ce temps</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copies the selected rows, or all that are shown: the newest 8 million characters</source>
        <translation>Copie les lignes choisies, ou toutes celles qui sont affichées&#xa0;: les 8 millions de caractères les plus récents</translation>
    </message>
    <message>
        <source>Link to send to</source>
        <translation>Liaison vers laquelle envoyer</translation>
    </message>
    <message>
        <source>Text to send</source>
        <translation>Texte à envoyer</translation>
    </message>
    <message>
        <source>ends with \n</source>
        <translation>se termine par \n</translation>
    </message>
    <message>
        <source>ends with \r</source>
        <translation>se termine par \r</translation>
    </message>
    <message>
        <source>ends with \r\n</source>
        <translation>se termine par \r\n</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>hexadecimal</source>
        <translation>hexadécimal</translation>
    </message>
    <message>
        <source>End of the text</source>
        <translation>Fin du texte</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Envoyer</translation>
    </message>
    <message>
        <source>Traffic of the links</source>
        <translation>Trafic des liaisons</translation>
    </message>
</context>
<context>
    <name>bask::DeviceDialog</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>Prendre un profil dans un fichier</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>Profils (*.json)</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>Interrogation…</translation>
    </message>
    <message>
        <source>Channels %1</source>
        <translation>Voies %1</translation>
    </message>
    <message>
        <source>Temperature %1</source>
        <translation>Température %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…)</source>
        <translation>Un numéro (0), un appareil (/dev/video0), un fichier vidéo, un dossier d’images ou une adresse (rtsp://…)</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Choose one, or type its path</source>
        <translation>Choisissez-en un, ou tapez son chemin</translation>
    </message>
    <message>
        <source>Set up: %1</source>
        <translation>Réglage : %1</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>Pilote</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>Actualiser</translation>
    </message>
    <message>
        <source>Look for ports anew</source>
        <translation>Chercher de nouveau les ports</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>Take what the device&apos;s registers mean from a file</source>
        <translation>Prendre dans un fichier le sens des registres de l’appareil</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Voies</translation>
    </message>
    <message>
        <source>The channel of each object&apos;s sensor, counted from 0</source>
        <translation>La voie du capteur de chaque objet, comptée à partir de 0</translation>
    </message>
    <message>
        <source>Its external probe measures the surface</source>
        <translation>Sa sonde externe mesure la surface</translation>
    </message>
    <message>
        <source>Test read</source>
        <translation>Lecture d’essai</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>Use this device in the experiment</source>
        <translation>Utiliser cet appareil dans l’expérience</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Asks the device without using it. Nothing moves or heats.</source>
        <translation>Interroge l’appareil sans l’utiliser. Rien ne bouge ni ne chauffe.</translation>
    </message>
    <message>
        <source>No serial port was found. Plug the device in and refresh, or type a path.</source>
        <translation>Aucun port série n’a été trouvé. Branchez l’appareil et actualisez, ou tapez un chemin.</translation>
    </message>
    <message>
        <source>1. Which device</source>
        <translation>1. Quel appareil</translation>
    </message>
    <message>
        <source>2. Where it is connected</source>
        <translation>2. Où il est branché</translation>
    </message>
    <message>
        <source>3. Does it answer?</source>
        <translation>3. Répond-il ?</translation>
    </message>
    <message>
        <source>4. Its axes</source>
        <translation>4. Ses axes</translation>
    </message>
    <message>
        <source>4. The objects&apos; channels</source>
        <translation>4. Les voies des objets</translation>
    </message>
    <message>
        <source>4. The device&apos;s own settings</source>
        <translation>4. Les réglages propres à l’appareil</translation>
    </message>
    <message>
        <source>May heat without a watchdog</source>
        <translation>Peut chauffer sans chien de garde</translation>
    </message>
    <message>
        <source>Then the source stays hot when Bask or the computer stops. Never leave it alone.</source>
        <translation>La source reste alors chaude quand Bask ou l’ordinateur s’arrête. Ne la laissez jamais seule.</translation>
    </message>
    <message>
        <source>Its place is sure</source>
        <translation>Sa position est sûre</translation>
    </message>
    <message>
        <source>Once it is homed, if its controller can; else once it is confirmed</source>
        <translation>Après la prise d’origine, si son contrôleur le peut ; sinon après confirmation</translation>
    </message>
    <message>
        <source>Once it is homed</source>
        <translation>Après la prise d’origine</translation>
    </message>
    <message>
        <source>Once it is homed or confirmed</source>
        <translation>Après prise d’origine ou confirmation</translation>
    </message>
    <message>
        <source>Host name or IP address of the device</source>
        <translation>Nom d’hôte ou adresse IP de l’appareil</translation>
    </message>
    <message>
        <source>Picture from %1 to %2</source>
        <translation>Image de %1 à %2</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a recorded frame or a folder of frames</source>
        <translation>Un numéro (0), un périphérique (/dev/video0), une image enregistrée ou un dossier d’images</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>The program and its arguments: python3 /home/lab/my_robot.py</source>
        <translation>Le programme et ses arguments&#xa0;: python3 /home/lab/my_robot.py</translation>
    </message>
    <message>
        <source>When its program says so</source>
        <translation>Quand son programme le dit</translation>
    </message>
</context>
<context>
    <name>bask::DialogFrame</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>bask::Display</name>
    <message>
        <source>%1/min</source>
        <comment>a rate; %1 is K or °F</comment>
        <translation>%1/min</translation>
    </message>
    <message>
        <source>The rig cannot be armed or started yet.</source>
        <translation>Le banc ne peut pas encore être armé ni démarré.</translation>
    </message>
    <message>
        <source>Nothing stands in the way: press Arm.</source>
        <translation>Rien ne s’y oppose&#xa0;: pressez Armer.</translation>
    </message>
    <message>
        <source>The sensors are zeroed and the recording is open: press Start.</source>
        <translation>Les capteurs sont ajustés et l’enregistrement est ouvert&#xa0;: pressez Démarrer.</translation>
    </message>
    <message>
        <source>The robot moves the objects towards their targets.</source>
        <translation>Le robot amène les objets vers leurs consignes.</translation>
    </message>
    <message>
        <source>Zero velocity; the controller&apos;s state is kept. Press Resume to go on.</source>
        <translation>Vitesse nulle&#xa0;; l’état du régulateur est conservé. Pressez Reprendre pour continuer.</translation>
    </message>
    <message>
        <source>All objects stay within their tolerance band. The controller keeps working.</source>
        <translation>Tous les objets restent dans leur bande de tolérance. Le régulateur continue.</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>encore aucune valeur</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>il y a %1 s</translation>
    </message>
    <message>
        <source>%1 old</source>
        <comment>%1 is minutes and seconds</comment>
        <translation>il y a %1</translation>
    </message>
    <message>
        <source>Nothing is armed.</source>
        <translation>Rien n’est armé.</translation>
    </message>
    <message>
        <source>The robot takes the objects away, and the heat was ordered off.</source>
        <translation>Le robot éloigne les objets, et l’ordre de couper le chauffage est donné.</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>L’essai est terminé.</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>Un arrêt ou un défaut est verrouillé. Supprimez sa cause, puis pressez Réinitialiser.</translation>
    </message>
</context>
<context>
    <name>bask::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
</context>
<context>
    <name>bask::EvennessText</name>
    <message>
        <source>even</source>
        <translation>uniforme</translation>
    </message>
    <message>
        <source>Parts: %1, which radiate %2 to %3 % of what an even one does</source>
        <translation>Parties : %1, qui rayonnent de %2 à %3 % de ce que rayonne une source uniforme</translation>
    </message>
    <message>
        <source>Radial profile of %1 points, radiating %2 to %3 % of what an even one does</source>
        <translation>Profil radial de %1 points, rayonnant de %2 à %3 % de ce que rayonne une source uniforme</translation>
    </message>
</context>
<context>
    <name>bask::EventList</name>
    <message>
        <source>Priority %1</source>
        <translation>Priorité&#xa0;%1</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>Événements et notes</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Nature</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Ce qui s’est passé</translation>
    </message>
</context>
<context>
    <name>bask::ExperimentEdit</name>
    <message>
        <source>target of “%1”</source>
        <translation>consigne de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>consignes</translation>
    </message>
    <message>
        <source>controller and gains</source>
        <translation>régulateur et gains</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>marqueurs</translation>
    </message>
    <message>
        <source>calibration of the camera</source>
        <translation>étalonnage de la caméra</translation>
    </message>
    <message>
        <source>place of the camera</source>
        <translation>place de la caméra</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>étalonnage</translation>
    </message>
    <message>
        <source>place of the source</source>
        <translation>place de la source</translation>
    </message>
    <message>
        <source>following of the source</source>
        <translation>suivi de la source</translation>
    </message>
    <message>
        <source>start of runs</source>
        <translation>départ des essais</translation>
    </message>
    <message>
        <source>set point of the source</source>
        <translation>température de consigne de la source</translation>
    </message>
    <message>
        <source>emittance of the source</source>
        <translation>émissivité de la source</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>espace de travail</translation>
    </message>
    <message>
        <source>limits of motion</source>
        <translation>limites de mouvement</translation>
    </message>
    <message>
        <source>safety limits</source>
        <translation>limites de sécurité</translation>
    </message>
    <message>
        <source>choice of the real rig</source>
        <translation>choix du banc réel</translation>
    </message>
    <message>
        <source>devices of the rig</source>
        <translation>appareils du banc</translation>
    </message>
    <message>
        <source>choice of the simulated rig</source>
        <translation>choix du banc simulé</translation>
    </message>
    <message>
        <source>move of “%1”</source>
        <translation>déplacement de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>déplacements</translation>
    </message>
    <message>
        <source>renaming of “%1”</source>
        <translation>nouveau nom de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>names</source>
        <translation>noms</translation>
    </message>
    <message>
        <source>start values of “%1”</source>
        <translation>valeurs de départ de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>start values</source>
        <translation>valeurs de départ</translation>
    </message>
    <message>
        <source>material of “%1”</source>
        <translation>matériau de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>matériaux</translation>
    </message>
    <message>
        <source>outline of “%1”</source>
        <translation>contour de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>outlines</source>
        <translation>contours</translation>
    </message>
    <message>
        <source>change of “%1”</source>
        <translation>modification de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>change of several objects</source>
        <translation>modification de plusieurs objets</translation>
    </message>
    <message>
        <source>addition of “%1”</source>
        <translation>ajout de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>removal of “%1”</source>
        <translation>retrait de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>change of the experiment</source>
        <translation>modification de l’expérience</translation>
    </message>
    <message>
        <source>air in the room</source>
        <translation>air de la pièce</translation>
    </message>
    <message>
        <source>calibration of the thermal camera</source>
        <translation>étalonnage de la caméra thermique</translation>
    </message>
</context>
<context>
    <name>bask::ExportBar</name>
    <message>
        <source>Computing…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Picture %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Avancement de l’exportation</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>Annuler l’exportation</translation>
    </message>
</context>
<context>
    <name>bask::FaultMenu</name>
    <message>
        <source>Not on a real rig: faults are simulated on the simulated rig only.</source>
        <translation>Pas sur un banc réel&#xa0;: les défauts ne se simulent que sur le banc simulé.</translation>
    </message>
    <message>
        <source>No simulated fault is active.</source>
        <translation>Aucun défaut simulé n’est actif.</translation>
    </message>
    <message>
        <source>Active. Choose it again to end it.</source>
        <translation>Actif. Choisissez-le de nouveau pour y mettre fin.</translation>
    </message>
    <message>
        <source>&amp;Simulate fault</source>
        <translation>&amp;Simuler un défaut</translation>
    </message>
</context>
<context>
    <name>bask::FaultWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>a fault, and the object that it is about</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Shows once the object is warmer than the room.</source>
        <translation>Se voit dès que l’objet est plus chaud que la pièce.</translation>
    </message>
    <message>
        <source>Shows once the two objects have different temperatures.</source>
        <translation>Se voit dès que les deux objets ont des températures différentes.</translation>
    </message>
    <message>
        <source>Shows when the heat is switched off.</source>
        <translation>Se voit quand on coupe le chauffage.</translation>
    </message>
    <message>
        <source>Shows in the picture of the Calibrate page only: nothing else here uses the camera.</source>
        <translation>Ne se voit que dans l’image de la page Étalonner&#xa0;: rien d’autre ici n’utilise la caméra.</translation>
    </message>
    <message>
        <source>Would show nothing here: the thermal camera reads the object, no sensor does.</source>
        <translation>Ne montrerait rien ici&#xa0;: c’est la caméra thermique qui lit l’objet, aucun capteur.</translation>
    </message>
    <message>
        <source>Would show nothing here: there is no other sensor to swap with.</source>
        <translation>Ne montrerait rien ici&#xa0;: il n’y a pas d’autre capteur à échanger.</translation>
    </message>
    <message>
        <source>Would show nothing here: the source has no markers, and nothing follows it.</source>
        <translation>Ne montrerait rien ici&#xa0;: la source n’a pas de marqueurs, et rien ne la suit.</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is off. Start a run or heat by hand first.</source>
        <translation>Ne montrerait rien maintenant&#xa0;: le chauffage est coupé. Démarrez d’abord un essai ou chauffez à la main.</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is on. Stop the run or switch it off first.</source>
        <translation>Ne montrerait rien maintenant&#xa0;: le chauffage est en marche. Arrêtez d’abord l’essai ou coupez-le.</translation>
    </message>
    <message>
        <source>Would change no run here: no camera follows the source, and there is no thermal camera.</source>
        <translation>Ne changerait rien à un essai ici : aucune caméra ne suit la source, et il n’y a pas de caméra thermique.</translation>
    </message>
</context>
<context>
    <name>bask::FigureDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>With a &amp;heading</source>
        <translation>Avec un &amp;en-tête</translation>
    </message>
    <message>
        <source>Size of the figure</source>
        <translation>Taille de la figure</translation>
    </message>
    <message>
        <source>One column: %1 mm</source>
        <translation>Une colonne : %1 mm</translation>
    </message>
    <message>
        <source>Two columns: %1 mm</source>
        <translation>Deux colonnes : %1 mm</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Title, names of the files and marked moments. Without it, a simulated run is called so in the corner.</source>
        <translation>Titre, noms des fichiers et moments marqués. Sans lui, un essai simulé est désigné comme tel dans le coin.</translation>
    </message>
    <message>
        <source>&amp;Size on paper</source>
        <translation>&amp;Taille sur papier</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>The letters have 7 to 9 points at any width.</source>
        <translation>Les lettres ont 7 à 9 points à toute largeur.</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>Choisir l’emplacement…</translation>
    </message>
</context>
<context>
    <name>bask::FinalValuesTable</name>
    <message>
        <source>Final values</source>
        <translation>Valeurs finales</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>non stabilisé</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>Finale</translation>
    </message>
    <message>
        <source>What the thermometer read when the run was stopped</source>
        <translation>Ce que le thermomètre lisait à l’arrêt de l’essai</translation>
    </message>
    <message>
        <source>The simulated object&apos;s own temperature when the run was stopped, which no sensor tells</source>
        <translation>La température propre de l’objet simulé à l’arrêt de l’essai, qu’aucun capteur n’indique</translation>
    </message>
    <message>
        <source>True</source>
        <translation>Réelle</translation>
    </message>
    <message>
        <source>Settled at</source>
        <translation>Stabilisé à</translation>
    </message>
    <message>
        <source>Time of the run from which the object stays within %1 of its target until the end</source>
        <translation>Instant de l’essai à partir duquel l’objet reste à moins de %1 de sa consigne jusqu’à la fin</translation>
    </message>
</context>
<context>
    <name>bask::HarmonicsPanel</name>
    <message>
        <source>&amp;Harmonics</source>
        <translation>&amp;Harmoniques</translation>
    </message>
    <message>
        <source>Number of harmonics</source>
        <translation>Nombre d’harmoniques</translation>
    </message>
    <message>
        <source>With this number of harmonics the outline crosses itself; choose another.</source>
        <translation>Avec ce nombre d’harmoniques, le contour se recoupe&#xa0;; choisissez-en un autre.</translation>
    </message>
    <message>
        <source>Fitting…</source>
        <translation>Ajustement en cours…</translation>
    </message>
    <message>
        <source>Residual &lt;b&gt;%1 mm&lt;/b&gt; rms, &lt;b&gt;%2 mm&lt;/b&gt; at most; Hausdorff &lt;b&gt;%3 mm&lt;/b&gt;; area &lt;b&gt;%4 %&lt;/b&gt;</source>
        <translation>Résidu &lt;b&gt;%1&#xa0;mm&lt;/b&gt; efficace, &lt;b&gt;%2&#xa0;mm&lt;/b&gt; au plus&#xa0;; Hausdorff &lt;b&gt;%3&#xa0;mm&lt;/b&gt;&#xa0;; aire &lt;b&gt;%4&#xa0;%&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 mm cannot be reached with up to %2 harmonics: %3 of them come closest, within %4 mm. The outline itself is exact.</source>
        <translation>%1&#xa0;mm ne peut être atteint avec au plus %2 harmoniques&#xa0;: %3 s’en approchent le mieux, à moins de %4&#xa0;mm. Le contour lui-même est exact.</translation>
    </message>
    <message>
        <source>With any number of harmonics up to %1 the outline crosses itself. The outline itself is exact.</source>
        <translation>Quel que soit le nombre d’harmoniques jusqu’à %1, le contour se recoupe. Le contour lui-même est exact.</translation>
    </message>
    <message>
        <source>Fitting… %1 of %2</source>
        <translation>Ajustement… %1 sur %2</translation>
    </message>
    <message>
        <source>Fewest harmonics &amp;within</source>
        <translation>Le &amp;moins d’harmoniques pour</translation>
    </message>
    <message>
        <source>Chooses the fewest harmonics whose outline does not cross itself and is nowhere farther from the imported one than this (Hausdorff distance).</source>
        <translation>Choisit le plus petit nombre d’harmoniques dont le contour ne se recoupe pas et ne s’éloigne nulle part davantage du contour importé (distance de Hausdorff).</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance within which the Fourier outline shall be</source>
        <translation>Distance à laquelle le contour de Fourier doit rester</translation>
    </message>
    <message>
        <source>Use the outli&amp;ne itself</source>
        <translation>&amp;Utiliser le contour lui-même</translation>
    </message>
    <message>
        <source>Takes the imported outline as a polygon, corner by corner, in place of a Fourier outline. Exact; slower the more corners it has.</source>
        <translation>Prend le contour importé comme polygone, sommet par sommet, au lieu d’un contour de Fourier. Exact&#xa0;; d’autant plus lent qu’il a de sommets.</translation>
    </message>
    <message>
        <source>The imported outline itself is used: %1 corners.</source>
        <translation>Le contour importé lui-même est utilisé&#xa0;: %1 sommets.</translation>
    </message>
    <message>
        <source>The imported outline itself is used, thinned from %1 to %2 corners.</source>
        <translation>Le contour importé lui-même est utilisé, réduit de %1 à %2 sommets.</translation>
    </message>
    <message>
        <source>Take %1</source>
        <comment>a number of harmonics</comment>
        <translation>Prendre %1</translation>
    </message>
    <message>
        <source>Take %1 harmonics</source>
        <translation>Prendre %1 harmoniques</translation>
    </message>
    <message>
        <source>Residual: between points at equal arc length, as a root mean square (rms) and at most. Hausdorff distance: the farthest that any point of one outline is from the nearest of the other; it is what &quot;Fewest harmonics within&quot; is about. Area: of the Fourier outline against the imported one.</source>
        <translation>Résidu&#xa0;: entre points de même abscisse curviligne, en moyenne quadratique (rms) et au plus. Distance de Hausdorff&#xa0;: le plus grand éloignement d’un point d’un contour au point le plus proche de l’autre&#xa0;; c’est d’elle qu’il s’agit dans «&#xa0;Le moins d’harmoniques pour&#xa0;». Aire&#xa0;: celle du contour de Fourier par rapport au contour importé.</translation>
    </message>
</context>
<context>
    <name>bask::HeatPanel</name>
    <message>
        <source>Heat the source</source>
        <translation>Chauffer la source</translation>
    </message>
    <message>
        <source>The source heats towards %1 until it is switched off. Is nothing on it or near it that must not get hot?</source>
        <translation>La source chauffe vers %1 jusqu’à ce qu’on l’arrête. N’y a-t-il rien dessus ou à côté qui ne doive pas chauffer ?</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Chauffer</translation>
    </message>
    <message>
        <source>A person keeps the source hot: %1 as typed last.</source>
        <translation>Une personne maintient la source chaude : %1 selon la dernière saisie.</translation>
    </message>
    <message>
        <source>Heating towards %1: %2 now.</source>
        <translation>Chauffage vers %1 : %2 à présent.</translation>
    </message>
    <message>
        <source>The heat is on: %1 now.</source>
        <translation>Le chauffage est en marche : %1 à présent.</translation>
    </message>
    <message>
        <source>The heat is off: %1 now.</source>
        <translation>Le chauffage est arrêté : %1 à présent.</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Set point of the source</source>
        <translation>Consigne de la source</translation>
    </message>
    <message>
        <source>Heat the source until it is switched off</source>
        <translation>Chauffer la source jusqu’à ce qu’on l’arrête</translation>
    </message>
    <message>
        <source>Heat off</source>
        <translation>Arrêter le chauffage</translation>
    </message>
    <message>
        <source>Measured by you</source>
        <translation>Mesurée par vous</translation>
    </message>
    <message>
        <source>Temperature of the source as you measured it</source>
        <translation>Température de la source que vous avez mesurée</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Prendre</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats: it was asked to heat towards %1. Last seen: %2.</source>
        <translation>INCONNU si elle chauffe : il lui a été demandé de chauffer vers %1. Vu en dernier : %2.</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats. Last seen: %1. Take it for hot.</source>
        <translation>INCONNU si elle chauffe. Vu en dernier : %1. Tenez-la pour chaude.</translation>
    </message>
    <message>
        <source>It heats though its heat is off: %1 now. Switch it off at its mains.</source>
        <translation>Elle chauffe bien que son chauffage soit arrêté : %1 maintenant. Coupez son alimentation.</translation>
    </message>
    <message>
        <source>The heat is off: %1 now, behind the closed shutter of the simulated source.</source>
        <translation>Le chauffage est arrêté : %1 à présent, derrière l’obturateur fermé de la source simulée.</translation>
    </message>
</context>
<context>
    <name>bask::HeldControls</name>
    <message>
        <source>Play</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>Play the surfaces through the robot&apos;s range of the value held, in nine steps.</source>
        <translation>Animer les surfaces sur la plage du robot de la valeur fixée, en neuf pas.</translation>
    </message>
    <message>
        <source>As at the pose</source>
        <translation>À la pose</translation>
    </message>
    <message>
        <source>Draw the surfaces at the values of the pose that was found.</source>
        <translation>Tracer les surfaces aux valeurs de la pose trouvée.</translation>
    </message>
    <message>
        <source>Position at which the surfaces are drawn: %1</source>
        <translation>Position à laquelle les surfaces sont tracées : %1</translation>
    </message>
    <message>
        <source>Angle at which the surfaces are drawn: %1</source>
        <translation>Angle auquel les surfaces sont tracées : %1</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedLosses</name>
    <message>
        <source>Losses from the record</source>
        <translation>Pertes d’après l’enregistrement</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>At</source>
        <translation>À</translation>
    </message>
    <message>
        <source>Loss, K/s</source>
        <translation>Perte, K/s</translation>
    </message>
    <message>
        <source>Median temperature of the record&apos;s second half</source>
        <translation>Température médiane de la seconde moitié de l’enregistrement</translation>
    </message>
    <message>
        <source>What radiation and air take together, less what the room gives, with its standard error</source>
        <translation>Ce que le rayonnement et l’air prennent ensemble, moins ce que la pièce donne, avec son erreur type</translation>
    </message>
    <message>
        <source>Convection of the air, from the curvature of the radiation&apos;s fourth power</source>
        <translation>Convection de l’air, d’après la courbure de la puissance quatrième du rayonnement</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>non déterminé</translation>
    </message>
    <message>
        <source>Its change with the object&apos;s temperature: %1 1/s</source>
        <translation>Sa variation avec la température de l’objet : %1 1/s</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedTable</name>
    <message>
        <source>Heat rates from the record</source>
        <translation>Coefficients thermiques tirés de l’enregistrement</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Identified</source>
        <translation>Identifié</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Régulateur</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>λ₁ by least squares on the whole record, with its standard error</source>
        <translation>λ₁ par moindres carrés sur tout l’enregistrement, avec son erreur type</translation>
    </message>
    <message>
        <source>λ₁ that the controller believed at the end</source>
        <translation>λ₁ que le régulateur retenait à la fin</translation>
    </message>
    <message>
        <source>λ₁ of the experiment&apos;s material and source</source>
        <translation>λ₁ du matériau et de la source de l’expérience</translation>
    </message>
    <message>
        <source>λ₂ = %1 1/(K³ s), λ₃ = %2 K/s</source>
        <translation>λ₂ = %1 1/(K³ s), λ₃ = %2 K/s</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>inutilisable</translation>
    </message>
    <message>
        <source>At Start</source>
        <translation>Au démarrage</translation>
    </message>
    <message>
        <source>λ₁ with which the controller began</source>
        <translation>λ₁ avec lequel le régulateur a commencé</translation>
    </message>
</context>
<context>
    <name>bask::ImportPanel</name>
    <message>
        <source>%1, hole in %2</source>
        <translation>%1, trou dans %2</translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, ouvert</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>C&amp;ontours</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>Importer un contour</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Outline %1: %2 points, %3 around.</source>
        <translation>Contour %1 : %2 points, périmètre %3.</translation>
    </message>
    <message>
        <source>Outlines of the file</source>
        <translation>Contours du fichier</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>Lecture du fichier</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>%1 counted off.</source>
        <translation>%1 déduits de l’aire.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>unités</translation>
    </message>
    <message>
        <source>The outline is %1 across; an object may be %2 at most. Correct its size.</source>
        <translation>Le contour fait %1 de large ; un objet peut faire %2 au plus. Corrigez sa taille.</translation>
    </message>
</context>
<context>
    <name>bask::ImportQuestions</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>&amp;Dictionnaire</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>&amp;Longueur</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>É&amp;chelle</translation>
    </message>
    <message>
        <source>&amp;Scale from</source>
        <translation>É&amp;chelle d’après</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>&amp;Tolérance</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>&amp;Unité</translation>
    </message>
    <message>
        <source>A printed ArUco marker lies beside the object, in the plane of its face. It tells the scale and undoes the perspective.</source>
        <translation>Un marqueur ArUco imprimé est posé à côté de l’objet, dans le plan de sa face. Il donne l’échelle et corrige la perspective.</translation>
    </message>
    <message>
        <source>Click its two ends</source>
        <translation>Cliquer ses deux bouts</translation>
    </message>
    <message>
        <source>Click the object</source>
        <translation>Cliquer l’objet</translation>
    </message>
    <message>
        <source>Dictionary of the marker</source>
        <translation>Dictionnaire du marqueur</translation>
    </message>
    <message>
        <source>Largest distance from the colour clicked, in CIE Lab; 0: found by itself</source>
        <translation>Distance maximale à la couleur cliquée, en CIE Lab ; 0 : trouvée automatiquement</translation>
    </message>
    <message>
        <source>Lay the ruler over a length that you know: drag its ends, or click both. The picture must be taken straight from above.</source>
        <translation>Posez la règle sur une longueur connue : glissez ses bouts ou cliquez-les. La photo doit être prise bien d’en haut.</translation>
    </message>
    <message>
        <source>Length of the ruler</source>
        <translation>Longueur de la règle</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Otherwise by the picture’s opacity or brightness.</source>
        <translation>Sinon à l’opacité ou à la luminosité de l’image.</translation>
    </message>
    <message>
        <source>S&amp;ide of its square</source>
        <translation>&amp;Côté de son carré</translation>
    </message>
    <message>
        <source>Scale of the picture, pixels per millimetre</source>
        <translation>Échelle de l’image, pixels par millimètre</translation>
    </message>
    <message>
        <source>Side of the marker’s black square</source>
        <translation>Côté du carré noir du marqueur</translation>
    </message>
    <message>
        <source>The picture must be taken straight from above, or scanned.</source>
        <translation>La photo doit être prise bien d’en haut, ou numérisée à plat.</translation>
    </message>
    <message>
        <source>Tolerance of the colour</source>
        <translation>Tolérance de la couleur</translation>
    </message>
    <message>
        <source>Unit of the coordinates</source>
        <translation>Unité des coordonnées</translation>
    </message>
    <message>
        <source>What gives the picture its scale</source>
        <translation>Ce qui donne l’échelle de l’image</translation>
    </message>
    <message>
        <source>a known length</source>
        <translation>une longueur connue</translation>
    </message>
    <message>
        <source>an ArUco marker in it</source>
        <translation>un marqueur ArUco</translation>
    </message>
    <message>
        <source>as its header says</source>
        <translation>selon l’en-tête</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>pixels per millimetre</source>
        <translation>pixels par millimètre</translation>
    </message>
    <message>
        <source>tell it by its colour</source>
        <translation>le reconnaître à sa couleur</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>Width of the outline chosen</source>
        <translation>Largeur du contour choisi</translation>
    </message>
    <message>
        <source>As the drawing says. Type another to make all of it larger or smaller.</source>
        <translation>Selon le dessin. Tapez-en une autre pour agrandir ou réduire le tout.</translation>
    </message>
    <message>
        <source>Its true size is not known yet: choose the unit above.</source>
        <translation>Sa taille vraie n’est pas encore connue : choisissez l’unité ci-dessus.</translation>
    </message>
    <message>
        <source>Its true size is not known yet: lay the ruler over the length above.</source>
        <translation>Sa taille vraie n’est pas encore connue : posez la règle sur la longueur ci-dessus.</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the length of the ruler above.</source>
        <translation>Sa taille vraie n’est pas encore connue : tapez ci-dessus la longueur de la règle.</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the scale above.</source>
        <translation>Sa taille vraie n’est pas encore connue : tapez l’échelle ci-dessus.</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the side of the marker’s square above.</source>
        <translation>Sa taille vraie n’est pas encore connue : tapez ci-dessus le côté du carré du marqueur.</translation>
    </message>
</context>
<context>
    <name>bask::InfeasibleDialog</name>
    <message>
        <source>Start all the same; the recording says so</source>
        <translation>Démarrer malgré tout&#xa0;; l’enregistrement le mentionne</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Targets out of reach</source>
        <translation>Consignes hors d’atteinte</translation>
    </message>
    <message>
        <source>The run would end at the best compromise it finds.
The Targets page says more and offers the nearest targets that can be held.</source>
        <translation>L’essai finirait au meilleur compromis trouvé.
La page Consignes en dit plus et propose les consignes les plus proches qui peuvent être tenues.</translation>
    </message>
</context>
<context>
    <name>bask::JogPanel</name>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Step along an axis</source>
        <translation>Pas le long d’un axe</translation>
    </message>
    <message>
        <source>Step about an axis</source>
        <translation>Pas autour d’un axe</translation>
    </message>
    <message>
        <source>Speed while held</source>
        <translation>Vitesse (maintien)</translation>
    </message>
    <message>
        <source>Of the largest speed that the robot&apos;s limits allow</source>
        <translation>Part de la plus grande vitesse que permettent les limites du robot</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Aller à</translation>
    </message>
    <message>
        <source>One step of %1 down</source>
        <translation>Un pas de %1 vers le bas</translation>
    </message>
    <message>
        <source>One step of %1 up</source>
        <translation>Un pas de %1 vers le haut</translation>
    </message>
    <message>
        <source>%1 downwards for as long as this is held</source>
        <translation>%1 diminue tant que ce bouton est maintenu</translation>
    </message>
    <message>
        <source>%1 upwards for as long as this is held</source>
        <translation>%1 augmente tant que ce bouton est maintenu</translation>
    </message>
    <message>
        <source>%1 to go to</source>
        <translation>%1 à atteindre</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Aller</translation>
    </message>
    <message>
        <source>Move to these coordinates; Hold (F7) ends it</source>
        <translation>Aller à ces coordonnées ; Pause (F7) y met fin</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Ici</translation>
    </message>
    <message>
        <source>Put in where the robot is</source>
        <translation>Mettre la position présente du robot</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Prise d’origine</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>Le robot cherche ses butées pour connaître sa position : il bouge</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>Effacer l’alarme</translation>
    </message>
    <message>
        <source>After you have seen to it: the robot is where it says. Nothing moves.</source>
        <translation>Après y avoir remédié : le robot est là où il le dit. Rien ne bouge.</translation>
    </message>
    <message>
        <source>Place UNKNOWN. What stands below is %1.</source>
        <translation>Position INCONNUE. Ce qui suit date : %1.</translation>
    </message>
    <message>
        <source>Place UNKNOWN: the robot has not told it yet.</source>
        <translation>Position INCONNUE : le robot ne l’a pas encore dite.</translation>
    </message>
    <message>
        <source>Confirm its place</source>
        <translation>Confirmer sa position</translation>
    </message>
</context>
<context>
    <name>bask::LabelsDialog</name>
    <message>
        <source>Before the run</source>
        <translation>Avant l’essai</translation>
    </message>
    <message>
        <source>Operator and sample</source>
        <translation>Opérateur et échantillon</translation>
    </message>
    <message>
        <source>The run that is on has it; it can be changed after the run.</source>
        <translation>L’essai en cours l’utilise&#xa0;; modifiable après l’essai.</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Lot</translation>
    </message>
    <message>
        <source>Recordings, reports and the list of runs show them. Each command, note and acknowledgement is recorded with its operator.</source>
        <translation>Les enregistrements, les rapports et la liste des essais les montrent. Chaque commande, note et acquittement est enregistré avec son opérateur.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Ask at each Arm</source>
        <translation>Demander à chaque armement</translation>
    </message>
</context>
<context>
    <name>bask::LargeNumbers</name>
    <message>
        <source>Run %1</source>
        <comment>%1 is the time since Start</comment>
        <translation>Essai %1</translation>
    </message>
    <message>
        <source>Source %1</source>
        <comment>%1 is its newest temperature</comment>
        <translation>Source %1</translation>
    </message>
    <message>
        <source>The engine is not answering: what is shown is old.</source>
        <translation>Le moteur ne répond pas&#xa0;: ce qui est affiché est ancien.</translation>
    </message>
    <message>
        <source>Bask: large numbers</source>
        <translation>Bask&#xa0;: grands nombres</translation>
    </message>
    <message>
        <source>In %1 s: %2</source>
        <comment>seconds, and what the engine does then</comment>
        <translation>Dans %1 s : %2</translation>
    </message>
</context>
<context>
    <name>bask::LimitsPanel</name>
    <message>
        <source>Heat source</source>
        <translation>Source de chaleur</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>Température mesurée</translation>
    </message>
    <message>
        <source>Set point of runs</source>
        <translation>Consigne des essais</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>Émissivité</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>Émissivité de la source</translation>
    </message>
    <message>
        <source>Workspace of the end-effector</source>
        <translation>Espace de travail de l’effecteur</translation>
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
        <source>Least %1</source>
        <translation>%1 le plus petit</translation>
    </message>
    <message>
        <source>Largest %1</source>
        <translation>%1 le plus grand</translation>
    </message>
    <message>
        <source>Limits of motion</source>
        <translation>Limites de mouvement</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1 : %2 au lieu de %3</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>Uniformité</translation>
    </message>
</context>
<context>
    <name>bask::LivePicture</name>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 images/s</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Live picture of the camera</source>
        <translation>Image en direct de la caméra</translation>
    </message>
    <message>
        <source>No picture yet: no camera is running.</source>
        <translation>Pas encore d’image : aucune caméra n’est en marche.</translation>
    </message>
    <message>
        <source>Nothing is found in the picture</source>
        <translation>Rien n’est trouvé dans l’image</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>âge %1 s</translation>
    </message>
    <message>
        <source>base</source>
        <translation>base</translation>
    </message>
    <message>
        <source>end-effector</source>
        <translation>effecteur</translation>
    </message>
    <message>
        <source>latency %1 ms</source>
        <translation>latence %1 ms</translation>
    </message>
    <message>
        <source>marker %1</source>
        <translation>marqueur %1</translation>
    </message>
    <message>
        <source>marker %1, %2</source>
        <translation>marqueur %1, %2</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulée</translation>
    </message>
    <message>
        <source>source</source>
        <translation>source</translation>
    </message>
    <message>
        <source>source predicted</source>
        <translation>source prédite</translation>
    </message>
    <message>
        <source>source searched</source>
        <translation>source recherchée</translation>
    </message>
    <message>
        <source>source tracked</source>
        <translation>source suivie</translation>
    </message>
    <message>
        <source>the board</source>
        <translation>la mire</translation>
    </message>
    <message>
        <source>two poses</source>
        <translation>deux poses</translation>
    </message>
</context>
<context>
    <name>bask::MainWindow</name>
    <message>
        <source>Not taken: the targets stay as they were.</source>
        <translation>Refusé : les consignes restent ce qu’elles étaient.</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Arm the real rig</source>
        <translation>Armer le banc réel</translation>
    </message>
    <message>
        <source>This rig is real: once the run is started, the robot moves and the source heats. Is everybody and everything out of the way?</source>
        <translation>Ce banc est réel : une fois l’essai lancé, le robot bouge et la source chauffe. Personne ni rien n’est-il sur le passage ?</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>Only files of this computer can be opened: save it here first.</source>
        <translation>Seuls les fichiers de cet ordinateur peuvent être ouverts&#xa0;: enregistrez-le d’abord ici.</translation>
    </message>
    <message>
        <source>Only one file can be opened at a time.</source>
        <translation>Un seul fichier peut être ouvert à la fois.</translation>
    </message>
    <message>
        <source>Unsaved edits cannot be kept for a crash: %1</source>
        <translation>Les modifications non enregistrées ne peuvent pas être gardées en cas de panne&#xa0;: %1</translation>
    </message>
    <message>
        <source>From the next start of Bask on, text and all that is drawn with it has %1 % of its size.</source>
        <translation>À partir du prochain démarrage de Bask, le texte et tout ce qui est dessiné avec lui auront %1 % de leur taille.</translation>
    </message>
    <message>
        <source>The window will then be larger than this screen.</source>
        <translation>La fenêtre sera alors plus grande que cet écran.</translation>
    </message>
    <message>
        <source>Bask closes when the objects are away from the source.</source>
        <translation>Bask se ferme quand les objets sont loin de la source.</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>Retrait</translation>
    </message>
    <message>
        <source>Retreat now</source>
        <translation>Retrait immédiat</translation>
    </message>
    <message>
        <source>This was the horn: the desktop&apos;s bell. If you heard nothing, it is off in the desktop&apos;s settings.</source>
        <translation>C’était l’avertisseur : le signal sonore du bureau. Si vous n’avez rien entendu, il est désactivé dans les réglages du bureau.</translation>
    </message>
    <message>
        <source>Bask stays open: the run ended by a fault. Look at the alarms.</source>
        <translation>Bask reste ouvert&#xa0;: l’essai s’est terminé par un défaut. Regardez les alarmes.</translation>
    </message>
    <message>
        <source>Simulated faults are active: %1. Tools &gt; Simulate fault ends them.</source>
        <translation>Des défauts simulés sont actifs&#xa0;: %1. Outils &gt; Simuler un défaut y met fin.</translation>
    </message>
    <message>
        <source>The objects are over the source, which has %1: its heat reaches them although no run is on. Warm sensors cannot be zeroed, and a run begins with objects as warm as they are then. Retreat takes them away.</source>
        <translation>Les objets sont au-dessus de la source, qui est à %1&#xa0;: sa chaleur les atteint bien qu’aucun essai ne soit en cours. Des capteurs chauds ne peuvent pas être ajustés, et un essai commence avec des objets aussi chauds qu’ils le sont alors. Retrait les éloigne.</translation>
    </message>
    <message>
        <source>source %1 of %2</source>
        <comment>temperatures: that of now, and the set point</comment>
        <translation>source %1 sur %2</translation>
    </message>
    <message>
        <source>over hot source: %1</source>
        <comment>the objects are over it; its temperature</comment>
        <translation>sur source chaude&#xa0;: %1</translation>
    </message>
    <message>
        <source>Arm the simulated rig</source>
        <translation>Armer le banc simulé</translation>
    </message>
    <message>
        <source>The robot will move: it takes the objects away from the source, and the heat goes off. Are all hands off the robot and is nothing in its way?</source>
        <translation>Le robot va bouger&#xa0;: il éloigne les objets de la source, et le chauffage est coupé. Toutes les mains sont-elles loin du robot et rien ne lui fait-il obstacle&#xa0;?</translation>
    </message>
    <message>
        <source>Home the robot</source>
        <translation>Prise d’origine du robot</translation>
    </message>
    <message>
        <source>Home now</source>
        <translation>Lancer la prise d’origine</translation>
    </message>
    <message>
        <source>The question &quot;%1&quot; was closed: the state has changed since it was asked.</source>
        <translation>La question « %1 » a été fermée : l’état a changé depuis qu’elle a été posée.</translation>
    </message>
    <message>
        <source>ready in %1 s</source>
        <comment>readings are being collected</comment>
        <translation>prêt dans %1 s</translation>
    </message>
    <message>
        <source>The robot will move: it seeks its switches to know its place. Are all hands off the robot and is nothing in its way?</source>
        <translation>Le robot va bouger : il cherche ses contacts pour connaître sa position. Toutes les mains sont-elles loin du robot et rien n’est-il sur son passage ?</translation>
    </message>
    <message>
        <source>%1. Are they mounted so all the same?</source>
        <translation>%1. Sont-ils tout de même montés ainsi ?</translation>
    </message>
    <message>
        <source>Nothing else begins while the question &quot;%1&quot; is open: answer it first. Hold, Stop and STOP are possible.</source>
        <translation>Rien d’autre ne commence tant que la question « %1 » est ouverte : répondez-y d’abord. Pause, Arrêter et STOP restent possibles.</translation>
    </message>
    <message>
        <source>Ready, but: %1. Arm asks about it.</source>
        <translation>Prêt, mais : %1. Armer le demandera.</translation>
    </message>
    <message>
        <source>Ready; whether the targets can be held is being checked.</source>
        <translation>Prêt ; vérification en cours : les consignes peuvent-elles être tenues ?</translation>
    </message>
    <message>
        <source>Ready, but: %1. Start asks about it.</source>
        <translation>Prêt, mais : %1. Démarrer le demandera.</translation>
    </message>
    <message>
        <source>objects overlap</source>
        <translation>chevauchement</translation>
    </message>
    <message>
        <source>cannot be held</source>
        <comment>the targets</comment>
        <translation>consignes intenables</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP pressé</translation>
    </message>
    <message>
        <source>The targets cannot be held: %1. Start asks about it.</source>
        <translation>Les consignes ne peuvent être tenues : %1. Démarrer le demandera.</translation>
    </message>
    <message>
        <source>The objects stay where they are, near the source, and go on towards the temperature that they reach there; Retreat takes them away.</source>
        <translation>Les objets restent où ils sont, près de la source, et continuent vers la température qu’ils y atteignent ; Retrait les éloigne.</translation>
    </message>
</context>
<context>
    <name>bask::ManualWindow</name>
    <message>
        <source>Bask: manual</source>
        <translation>Bask : manuel</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>Texte du manuel</translation>
    </message>
    <message>
        <source>This page is in English only.</source>
        <translation>Cette page n’existe qu’en anglais.</translation>
    </message>
</context>
<context>
    <name>bask::MarkerEditor</name>
    <message>
        <source>%1 px off</source>
        <translation>à %1 px près</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Base</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>Dictionnaire</translation>
    </message>
    <message>
        <source>End-effector</source>
        <translation>Effecteur</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Lists another marker: one that the camera sees and that is not listed, if there is one</source>
        <translation>Ajoute un marqueur à la liste : un que la caméra voit et qui n’y est pas, s’il y en a un</translation>
    </message>
    <message>
        <source>Markers of the rig</source>
        <translation>Marqueurs du montage</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Side, mm</source>
        <translation>Côté, mm</translation>
    </message>
    <message>
        <source>Sits on</source>
        <translation>Posé sur</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Where the marker&apos;s middle is on its part, and how its axes (x right, y up, z out of it) are turned there</source>
        <translation>Où le milieu du marqueur se trouve sur sa pièce, et comment ses axes (x à droite, y en haut, z vers l’extérieur) y sont tournés</translation>
    </message>
    <message>
        <source>With the black border, as measured on the print</source>
        <translation>Avec le bord noir, mesuré sur l’impression</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>autour de y, °</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>autour de z, °</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>non vu</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>vu</translation>
    </message>
    <message>
        <source>turned about x, °</source>
        <translation>tourné autour de x, °</translation>
    </message>
    <message>
        <source>two poses fit</source>
        <translation>deux poses possibles</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x, mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y, mm</translation>
    </message>
    <message>
        <source>z, mm</source>
        <translation>z, mm</translation>
    </message>
</context>
<context>
    <name>bask::MaterialControl</name>
    <message>
        <source>Your library of materials cannot be used and is left as it is: %1. Mend the file or move it elsewhere.</source>
        <translation>Votre bibliothèque de matériaux ne peut pas être utilisée et est laissée telle quelle&#xa0;: %1. Réparez le fichier ou déplacez-le ailleurs.</translation>
    </message>
    <message>
        <source>Import materials</source>
        <translation>Importer des matériaux</translation>
    </message>
    <message>
        <source>Materials (*.json);;All files (*)</source>
        <translation>Matériaux (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1: %2 added, %3 of them under another name, since theirs was taken; %4 were there already.</source>
        <translation>%1&#xa0;: %2 ajoutés, dont %3 sous un autre nom, le leur étant pris&#xa0;; %4 étaient déjà là.</translation>
    </message>
    <message>
        <source>Export the library of materials</source>
        <translation>Exporter la bibliothèque de matériaux</translation>
    </message>
    <message>
        <source>Materials (*.json)</source>
        <translation>Matériaux (*.json)</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>%1 a été écrit.</translation>
    </message>
</context>
<context>
    <name>bask::MaterialsDialog</name>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
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
        <source>Materials</source>
        <translation>Matériaux</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>The library is empty. “Save as material” on the Objects page adds an object&apos;s material, Import those of a file.</source>
        <translation>La bibliothèque est vide. «&#xa0;Enregistrer comme matériau&#xa0;» sur la page Objets y ajoute le matériau d’un objet, Importer ceux d’un fichier.</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>«&#xa0;%1&#xa0;» a été retiré.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>bask::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>Problème</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
</context>
<context>
    <name>bask::Metrics</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>start unknown</source>
        <translation>départ inconnu</translation>
    </message>
    <message>
        <source>step too small</source>
        <translation>échelon trop petit</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>non atteint</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>non stabilisé</translation>
    </message>
    <message>
        <source>%1 (s.d. %2)</source>
        <comment>mean with its unit, standard deviation without</comment>
        <translation>%1 (é.-t. %2)</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>Finale</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Temps de stabilisation</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>Temps de montée</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Dépassement</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>Erreur statique</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Longueur du trajet</translation>
    </message>
    <message>
        <source>Duration of control</source>
        <translation>Durée de l’asservissement</translation>
    </message>
    <message>
        <source>Path of the end-effector</source>
        <translation>Trajet de l’effecteur</translation>
    </message>
    <message>
        <source>Rotation of the end-effector</source>
        <translation>Rotation de l’effecteur</translation>
    </message>
    <message>
        <source>Time at a velocity limit</source>
        <translation>Temps en limite de vitesse</translation>
    </message>
    <message>
        <source>Time at any limit</source>
        <translation>Temps en limite, toutes confondues</translation>
    </message>
    <message>
        <source>The last target that was set. The other numbers count from that moment, or from Start when it was not changed, until Stop.</source>
        <translation>La dernière consigne fixée. Les autres valeurs comptent depuis ce moment, ou depuis le démarrage si elle n’a pas changé, jusqu’à l’arrêt.</translation>
    </message>
    <message>
        <source>How far the temperature went beyond the target in the direction of the step, and as a share of the step. Not given for steps under twice the band.</source>
        <translation>De combien la température a dépassé la consigne dans le sens de l’échelon, et en part de l’échelon. Non donné pour un échelon inférieur à deux fois la bande.</translation>
    </message>
    <message>
        <source>From Start until Stop.</source>
        <translation>Du démarrage à l’arrêt.</translation>
    </message>
    <message>
        <source>Sum of the angles by which the end-effector was turned from sample to sample.</source>
        <translation>Somme des angles dont l’effecteur a tourné d’un échantillon au suivant.</translation>
    </message>
    <message>
        <source>Time in which the limit of speed or of rotation held the command back.</source>
        <translation>Temps pendant lequel la limite de vitesse ou de rotation a retenu la commande.</translation>
    </message>
    <message>
        <source>Time in which a limit of any kind held the command back: speed, rotation, acceleration, clearance or workspace.</source>
        <translation>Temps pendant lequel une limite quelconque a retenu la commande : vitesse, rotation, accélération, garde ou espace de travail.</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>aucun échantillon</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>%1, true</source>
        <comment>a metric by the true temperature</comment>
        <translation>%1 (réel)</translation>
    </message>
    <message>
        <source>The same by the simulated object&apos;s own temperature, which no sensor tells.</source>
        <translation>La même valeur d’après la température propre de l’objet simulé, qu’aucun capteur n’indique.</translation>
    </message>
    <message>
        <source>What the object&apos;s thermometer read at the last sample until Stop. The other numbers take its readings, too. ± is the standard uncertainty: of a sensor that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings, without its own error away from the room&apos;s temperature and that of its contact.</source>
        <translation>Ce que le thermomètre de l’objet a lu au dernier échantillon avant l’arrêt. Les autres valeurs prennent aussi ses mesures. ± est l’incertitude type : pour un capteur, celle de la température de la pièce à laquelle il a été ajusté, de son ajustement, et du pas et du bruit de ses mesures, sans son erreur propre loin de la température de la pièce ni celle de son contact.</translation>
    </message>
    <message>
        <source>Mean of temperature minus target over the last %1 s until Stop, or since settling where that is less, with its standard uncertainty (±) and the standard deviation of the samples.</source>
        <translation>Moyenne de la température moins la consigne sur les %1 dernières secondes avant l’arrêt, ou depuis la stabilisation si c’est moins, avec son incertitude type (±) et l’écart-type des échantillons.</translation>
    </message>
    <message>
        <source>, not sure</source>
        <comment>after a number</comment>
        <translation>, pas sûr</translation>
    </message>
    <message>
        <source>Time until the temperature stays within %1 of the target until Stop. The event &quot;All objects settled&quot; is another and comes later: when all objects have been so near for %2 s by the controller&apos;s estimates, and the robot needs no other place. ± is its standard uncertainty: how far readings that are wrong by theirs move that moment, and the period. Not sure: with such an error it would be outside at the end.</source>
        <translation>Temps au bout duquel la température reste à %1 de la consigne jusqu’à l’arrêt. L’événement « Tous les objets sont stabilisés » est autre chose et vient plus tard : quand tous les objets sont aussi proches depuis %2 s d’après les estimations du régulateur, et que le robot n’a pas à aller ailleurs. ± est son incertitude type : de combien des mesures fausses de la leur déplacent ce moment, et la période. Pas sûr : avec une telle erreur, la température serait hors de la bande à la fin.</translation>
    </message>
    <message>
        <source>Time between the first crossings of 10 % and of 90 % of the step, which leads from the temperature when the target was set to the target. Not given for steps under twice the band. ± is its standard uncertainty: how far wrong readings at the beginning and at both crossings move these.</source>
        <translation>Temps entre les premiers passages à 10 % et à 90 % de l’échelon, qui va de la température au moment où la consigne est fixée jusqu’à la consigne. Non donné pour un échelon inférieur à deux fois la bande. ± en est l’incertitude type : de combien des mesures fausses au début et aux deux passages les déplacent.</translation>
    </message>
    <message>
        <source>Length of the path of the object&apos;s centre in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>Longueur du trajet du centre de l’objet dans la base du robot, du démarrage à l’arrêt, d’après les positions signalées par le robot, dont aucun appareil ne dit l’incertitude.</translation>
    </message>
    <message>
        <source>Length of the path of the end-effector&apos;s origin in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>Longueur du trajet de l’origine de l’effecteur dans la base du robot, du démarrage à l’arrêt, d’après les positions signalées par le robot, dont aucun appareil ne dit l’incertitude.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Échelon</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <comment>difference of temperatures; time of the run</comment>
        <translation>%1 à %2 s</translation>
    </message>
    <message>
        <source>The target minus the temperature when it was set: at Start, or at the time beside it where the target was changed during the run. Times, overshoot and steady-state error are of this step.</source>
        <translation>La consigne moins la température au moment où elle a été fixée : au départ, ou à l’instant indiqué à côté si la consigne a été changée pendant l’essai. Temps, dépassement et erreur statique concernent cet échelon.</translation>
    </message>
</context>
<context>
    <name>bask::MetricsPanel</name>
    <message>
        <source>How these numbers are defined</source>
        <translation>Définition de ces indicateurs</translation>
    </message>
    <message>
        <source>Metrics of the run</source>
        <translation>Indicateurs de l’essai</translation>
    </message>
</context>
<context>
    <name>bask::MonitorControl</name>
    <message>
        <source>Monitoring is off: %1</source>
        <translation>La surveillance est désactivée&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>bask::MonitorDialog</name>
    <message>
        <source>Publish to an MQTT broker</source>
        <translation>Publier vers un courtier MQTT</translation>
    </message>
    <message>
        <source>Write status files</source>
        <translation>Écrire des fichiers d’état</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>Surveillance</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>Chiffré (TLS)</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>ceux du système</translation>
    </message>
    <message>
        <source>Its first line is the password; nobody else may read the file.</source>
        <translation>Sa première ligne est le mot de passe&#xa0;; personne d’autre ne doit pouvoir lire le fichier.</translation>
    </message>
    <message>
        <source>In front of all topics, with a slash: lab2/bask becomes lab2/bask/status and so on.</source>
        <translation>Devant tous les sujets, avec une barre&#xa0;: lab2/bask devient lab2/bask/status, etc.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Certificats de confiance</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Utilisateur</translation>
    </message>
    <message>
        <source>File with the password</source>
        <translation>Fichier du mot de passe</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>Sujet</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Folder of the status files</source>
        <translation>Dossier des fichiers d’état</translation>
    </message>
    <message>
        <source>Bask publishes only: nobody can give it an order this way, and it opens no port. The setting belongs to this computer; no experiment can switch it on.</source>
        <translation>Bask ne fait que publier&#xa0;: personne ne peut lui donner d’ordre par ce moyen, et il n’ouvre aucun port. Le réglage appartient à cet ordinateur&#xa0;; aucune expérience ne peut l’activer.</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Tester</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Essai en cours…</translation>
    </message>
    <message>
        <source>It works: everything that is ticked has taken a message.</source>
        <translation>Cela fonctionne&#xa0;: tout ce qui est coché a pris un message.</translation>
    </message>
    <message>
        <source>Without TLS the password goes over the network in clear text.</source>
        <translation>Sans TLS, le mot de passe circule en clair sur le réseau.</translation>
    </message>
</context>
<context>
    <name>bask::MountingPlan</name>
    <message>
        <source>Plan of the objects on the end-effector</source>
        <translation>Plan des objets sur l’effecteur</translation>
    </message>
    <message>
        <source>The objects on the end-effector, to scale. Drag one to move it in steps of 5 mm, its handle to turn it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down turn it.</source>
        <translation>Les objets sur l’effecteur, à l’échelle. Faites-en glisser un pour le déplacer par pas de 5 mm, sa poignée pour le tourner par pas de 5° ; avec Alt, finement. Les flèches déplacent de 1 mm celui qui est sélectionné, Page préc. et Page suiv. le tournent.</translation>
    </message>
    <message>
        <source>Grid %1, snap %2</source>
        <translation>Grille %1, pas %2</translation>
    </message>
    <message>
        <source>x %1 cm, y %2 cm, %3°</source>
        <translation>x %1 cm, y %2 cm, %3°</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the front</source>
        <translation>Objets sur l’effecteur vus de face</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the side</source>
        <translation>Objets sur l’effecteur vus de côté</translation>
    </message>
    <message>
        <source>The objects edge-on, to the scale of the plan. Drag one to change its height in steps of 5 mm, its handle to tilt it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down tilt it.</source>
        <translation>Les objets vus par la tranche, à l’échelle du plan. Faites-en glisser un pour changer sa hauteur par pas de 5 mm, sa poignée pour l’incliner par pas de 5° ; avec Alt, finement. Les flèches déplacent de 1 mm celui qui est sélectionné, Page préc. et Page suiv. l’inclinent.</translation>
    </message>
    <message>
        <source>z %1 cm, tilt %2° about x, %3° about y</source>
        <translation>z %1 cm, incliné de %2° autour de x, %3° autour de y</translation>
    </message>
    <message>
        <source>Arrows: where the heated faces look</source>
        <translation>Flèches : où regardent les faces chauffées</translation>
    </message>
</context>
<context>
    <name>bask::MountingViews</name>
    <message>
        <source>Heights and tilts</source>
        <translation>Hauteurs et inclinaisons</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>Seen along y: x to the right, z up</source>
        <translation>Vu le long de y : x vers la droite, z vers le haut</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Seen against x: y to the right, z up</source>
        <translation>Vu à l’opposé de x : y vers la droite, z vers le haut</translation>
    </message>
</context>
<context>
    <name>bask::NumberField</name>
    <message>
        <source>“%1” is not a number; the value stays as it was</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre&#xa0;; la valeur reste telle qu’elle était</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: %2 to %3</source>
        <translation>«&#xa0;%1&#xa0;» est hors limites&#xa0;; admis&#xa0;: de %2 à %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: this value has no unit</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas été pris&#xa0;: cette valeur n’a pas d’unité</translation>
    </message>
    <message>
        <source>“%1” was not taken: %2 is not a unit of this value, which is in %3</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas été pris&#xa0;: %2 n’est pas une unité de cette valeur, qui est en %3</translation>
    </message>
    <message>
        <source>“%1” may be one of two numbers: type %2 or %3</source>
        <translation>«&#xa0;%1&#xa0;» peut être l’un de deux nombres&#xa0;: saisissez %2 ou %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: with the digits of this field it would be %2</source>
        <translation>«&#xa0;%1&#xa0;» n’a pas été pris&#xa0;: avec les chiffres de ce champ, ce serait %2</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: more than %2, up to %3</source>
        <translation>«&#xa0;%1&#xa0;» est hors limites&#xa0;; admis&#xa0;: plus de %2, jusqu’à %3</translation>
    </message>
</context>
<context>
    <name>bask::ObjectList</name>
    <message>
        <source>disk, %1 cm</source>
        <translation>disque,&#xa0;%1 cm</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polygone</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>kind and target of an object</comment>
        <translation>%1 ·&#xa0;%2</translation>
    </message>
    <message>
        <source>%1: %2. Press F2 to rename.</source>
        <translation>%1&#xa0;:&#xa0;%2. F2 pour renommer.</translation>
    </message>
</context>
<context>
    <name>bask::ObjectProperties</name>
    <message>
        <source>Heat capacity</source>
        <translation>Capacité thermique</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>Constante de temps</translation>
    </message>
    <message>
        <source>Of the plate, per area that is seen</source>
        <translation>De la plaque, par surface vue</translation>
    </message>
    <message>
        <source>Of small changes about the target</source>
        <translation>Pour de petits écarts autour de la consigne</translation>
    </message>
    <message>
        <source>Heating at view factor 1 with the source as it is set</source>
        <translation>Chauffe au facteur de forme 1 avec la source telle que réglée</translation>
    </message>
    <message>
        <source>Times T⁴: what the object radiates</source>
        <translation>Fois T⁴ : ce que l’objet rayonne</translation>
    </message>
    <message>
        <source>What the surroundings give</source>
        <translation>Ce que donne l’environnement</translation>
    </message>
    <message>
        <source>typed values</source>
        <translation>valeurs saisies</translation>
    </message>
    <message>
        <source>typed values (%1)</source>
        <translation>valeurs saisies (%1)</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Disque</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>Contour de Fourier,&#xa0;%1</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Mounting on the end-effector</source>
        <translation>Montage sur l’effecteur</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>Périmètre</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Rotation about z</source>
        <translation>Rotation autour de z</translation>
    </message>
    <message>
        <source>Mounting x</source>
        <translation>Montage x</translation>
    </message>
    <message>
        <source>Mounting y</source>
        <translation>Montage y</translation>
    </message>
    <message>
        <source>Mounting z</source>
        <translation>Montage z</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>%1 J/(m²·K)</source>
        <translation>%1 J/(m²·K)</translation>
    </message>
    <message>
        <source>%1 K/s</source>
        <translation>%1 K/s</translation>
    </message>
    <message>
        <source>%1 K⁻³·s⁻¹</source>
        <translation>%1 K⁻³·s⁻¹</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 without holes</source>
        <translation>%1 sans les trous</translation>
    </message>
    <message>
        <source>z, height</source>
        <translation>z, hauteur</translation>
    </message>
    <message>
        <source>Tilt about x</source>
        <translation>Inclinaison autour de x</translation>
    </message>
    <message>
        <source>Tilt about y</source>
        <translation>Inclinaison autour de y</translation>
    </message>
    <message>
        <source>The object is turned about the end-effector&apos;s x first, then about its y, then about its z</source>
        <translation>L’objet est tourné d’abord autour de l’axe x de l’effecteur, puis autour de y, puis autour de z</translation>
    </message>
    <message>
        <source>Save as material…</source>
        <translation>Enregistrer comme matériau…</translation>
    </message>
    <message>
        <source>Keeps these values in your library of materials</source>
        <translation>Garde ces valeurs dans votre bibliothèque de matériaux</translation>
    </message>
    <message>
        <source>Materials…</source>
        <translation>Matériaux…</translation>
    </message>
    <message>
        <source>Your library of materials: see, rename, remove, import and export</source>
        <translation>Votre bibliothèque de matériaux&#xa0;: voir, renommer, retirer, importer et exporter</translation>
    </message>
</context>
<context>
    <name>bask::ObjectTile</name>
    <message>
        <source>Mean of the last 10 s</source>
        <translation>Moyenne des 10 dernières secondes</translation>
    </message>
    <message>
        <source>No reading yet</source>
        <translation>Pas encore de mesure</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>Chauffe</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>Refroidit</translation>
    </message>
    <message>
        <source>Off target</source>
        <comment>steady, outside the tolerance band</comment>
        <translation>Hors consigne</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Se stabilise</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Stabilisé</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Measured minus target</source>
        <translation>Mesure moins consigne</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objet&#xa0;%1</translation>
    </message>
    <message>
        <source>Measured temperature of %1</source>
        <translation>Température mesurée de&#xa0;%1</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <comment>the temperature of an object</comment>
        <translation>INCONNU</translation>
    </message>
    <message>
        <source>Stale</source>
        <comment>the reading of an object</comment>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>Not believed</source>
        <comment>the reading of an object</comment>
        <translation>Non cru</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Confirmer</translation>
    </message>
    <message>
        <source>Confirm the sensor of %1</source>
        <translation>Confirmer le capteur de %1</translation>
    </message>
    <message>
        <source>You have looked: the sensor is on its object and right. It is believed again.</source>
        <translation>Vous avez regardé : le capteur est sur son objet et juste. Il est cru de nouveau.</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Caméra %1</translation>
    </message>
    <message>
        <source>Above its warning limit</source>
        <comment>the temperature of an object</comment>
        <translation>Limite d’avertissement dépassée</translation>
    </message>
    <message>
        <source>Above its trip limit</source>
        <comment>the temperature of an object</comment>
        <translation>Limite de déclenchement dépassée</translation>
    </message>
    <message>
        <source>Standard uncertainty %1 %2. Of a sensor it is that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings. Not in it: the sensor&apos;s own error away from the room&apos;s temperature, and how well it touches its object.</source>
        <translation>Incertitude type %1 %2. Pour un capteur, c’est celle de la température de la pièce à laquelle il a été ajusté, de son ajustement, et du pas et du bruit de ses mesures. N’y sont pas : l’erreur propre du capteur loin de la température de la pièce, et la qualité de son contact avec l’objet.</translation>
    </message>
    <message>
        <source>same for %1 s</source>
        <comment>the value of a frozen sensor</comment>
        <translation>la même depuis %1 s</translation>
    </message>
    <message>
        <source>same for %1</source>
        <comment>the value of a frozen sensor; %1 is minutes and seconds</comment>
        <translation>la même depuis %1</translation>
    </message>
    <message>
        <source>Camera %1 (part)</source>
        <translation>Caméra %1 (partie)</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reading, or what the thermal camera sees of the object, with twice its own; of a reading that is not believed its age, or how long the sensor has told the same value. (part): some of the object is outside of the picture</source>
        <translation>Incertitude type de la mesure, ou ce que la caméra thermique voit de l’objet, avec le double de la sienne&#xa0;; d’une mesure qui n’est pas crue, son âge, ou depuis quand le capteur donne la même valeur. (partie)&#xa0;: l’objet est en partie hors de l’image</translation>
    </message>
</context>
<context>
    <name>bask::ObjectsPage</name>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de&#xa0;%1…</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>disque</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>«&#xa0;%1&#xa0;» a été supprimé.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>Importer un contour</translation>
    </message>
    <message>
        <source>Outlines (%1);;All files (*)</source>
        <translation>Contours (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>A disk is used as it is; it needs no fit.</source>
        <translation>Un disque est utilisé tel quel&#xa0;; il n’a pas besoin d’ajustement.</translation>
    </message>
    <message>
        <source>No imported outline is kept with this object, so it cannot be fitted again.</source>
        <translation>Aucun contour importé n’est conservé avec cet objet&#xa0;; il ne peut donc pas être réajusté.</translation>
    </message>
    <message>
        <source>Each object needs a free axis of the robot of its own; all are used. Remove an object first.</source>
        <translation>Chaque objet demande un axe libre du robot&#xa0;; tous sont pris. Supprimez d’abord un objet.</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>&amp;Objets</translation>
    </message>
    <message>
        <source>Add &amp;disk</source>
        <translation>Ajouter un &amp;disque</translation>
    </message>
    <message>
        <source>&amp;Import outline…</source>
        <translation>&amp;Importer un contour…</translation>
    </message>
    <message>
        <source>Du&amp;plicate</source>
        <translation>Du&amp;pliquer</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>%1 of %2 degrees of freedom used</source>
        <translation>%1 degrés de liberté utilisés sur&#xa0;%2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>&amp;Sample shapes</source>
        <translation>&amp;Formes d’exemple</translation>
    </message>
    <message>
        <source>Bunny</source>
        <translation>Lapin</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>Engrenage</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>%1 is not a kind of file that can be imported. Use a drawing (%2), a list of x, y points (%3) or a picture of a silhouette (%4).</source>
        <translation>%1 n’est pas un type de fichier importable. Utilisez un dessin (%2), une liste de points x, y (%3) ou l’image d’une silhouette (%4).</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Montage</translation>
    </message>
</context>
<context>
    <name>bask::Outcome</name>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Interrompu</translation>
    </message>
    <message>
        <source>Not settled</source>
        <translation>Non stabilisé</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Stabilisé</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Unreadable</source>
        <translation>Illisible</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Endommagé</translation>
    </message>
    <message>
        <source>Altered</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>%1, by an alarm of priority %2</source>
        <comment>the outcome of a run</comment>
        <translation>%1, par une alarme de priorité %2</translation>
    </message>
</context>
<context>
    <name>bask::OutlinePicker</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Outlines of the file</source>
        <translation>Contours du fichier</translation>
    </message>
    <message>
        <source>Click an outline to choose it. The wheel zooms, a double click shows all.</source>
        <translation>Cliquez un contour pour le choisir. La molette agrandit, un double clic montre tout.</translation>
    </message>
</context>
<context>
    <name>bask::OutlinePreview</name>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1, %2 mm wide and %3 mm high</source>
        <translation>%1, largeur&#xa0;%2 mm et hauteur&#xa0;%3 mm</translation>
    </message>
    <message>
        <source>Imported outline, %1 points</source>
        <translation>Contour importé,&#xa0;%1 points</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>Contour de Fourier,&#xa0;%1</translation>
    </message>
    <message>
        <source>Outline used</source>
        <translation>Contour utilisé</translation>
    </message>
    <message>
        <source>Drop a drawing, a CSV or a picture of a silhouette here, or add a disk.</source>
        <translation>Déposez ici un dessin, un CSV ou l’image d’une silhouette, ou ajoutez un disque.</translation>
    </message>
    <message>
        <source>%1 mm × %2 mm</source>
        <translation>%1 mm ×&#xa0;%2 mm</translation>
    </message>
    <message>
        <source>Centroid, principal axes: radii of gyration %1 mm and %2 mm</source>
        <translation>Centre et axes principaux&#xa0;: rayons de giration %1&#xa0;mm et %2&#xa0;mm</translation>
    </message>
    <message>
        <source>Imported outline at most %1 mm from the Fourier outline</source>
        <translation>Contour importé à %1&#xa0;mm au plus du contour de Fourier</translation>
    </message>
    <message>
        <source>Imported outline, %1 points, coloured by its distance</source>
        <translation>Contour importé, %1 points, coloré selon sa distance</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>0 mm</source>
        <translation>0&#xa0;mm</translation>
    </message>
</context>
<context>
    <name>bask::PageHost</name>
    <message>
        <source>A run is armed or on. Objects can be changed once it has stopped.</source>
        <translation>Un essai est armé ou en cours. Les objets pourront être modifiés après son arrêt.</translation>
    </message>
    <message>
        <source>The run is stopping. Targets can be changed once it has.</source>
        <translation>L’essai s’arrête. Les consignes pourront être modifiées ensuite.</translation>
    </message>
    <message>
        <source>Runs start at %1 from now on.</source>
        <translation>Les essais partent désormais de %1.</translation>
    </message>
    <message>
        <source>A run is armed or on. The start can be changed once it has stopped.</source>
        <translation>Un essai est armé ou en cours. Le départ pourra être changé une fois qu’il sera arrêté.</translation>
    </message>
    <message>
        <source>The source is followed no more: that takes markers on it, a calibrated camera and its place.</source>
        <translation>La source n’est plus suivie : il y faut des marqueurs sur elle, une caméra étalonnée et sa place.</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>Rétabli&#xa0;: %1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>Annulé&#xa0;: %1</translation>
    </message>
    <message>
        <source>Confirm a sensor</source>
        <translation>Confirmer un capteur</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. Have you looked, and is it on its object and right?</source>
        <translation>Le capteur de « %1 » indique %2. Avez-vous regardé, et est-il sur son objet et juste ?</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>Confirmer</translation>
    </message>
    <message>
        <source>A run is armed or on. The thermal camera can be changed once it has stopped.</source>
        <translation>Un essai est armé ou en cours. La caméra thermique pourra être changée quand il aura pris fin.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>%1 cannot be opened. Bask opens experiments and rigs (JSON), recorded sessions (BASK) and outlines (%2, pictures).</source>
        <comment>%2 names of file formats, with commas</comment>
        <translation>%1 ne peut pas être ouvert. Bask ouvre des expériences et des bancs (JSON), des sessions enregistrées (BASK) et des contours (%2, images).</translation>
    </message>
</context>
<context>
    <name>bask::PairsView</name>
    <message>
        <source>Folder for the tables and pictures</source>
        <translation>Dossier pour les tables et les images</translation>
    </message>
    <message>
        <source>Tables and pictures of the pairs written to %1</source>
        <translation>Tables et images des paires écrites dans %1</translation>
    </message>
    <message>
        <source>Maps need two objects or more.</source>
        <translation>Les cartes demandent au moins deux objets.</translation>
    </message>
    <message>
        <source>No pose of the workspace keeps the clearance: there is nothing to map.</source>
        <translation>Aucune pose de l’espace de travail ne respecte la garde : il n’y a rien à représenter.</translation>
    </message>
    <message>
        <source>Which temperatures two objects can have together, whatever the others do. Drag a point, or double-click, to set their targets.</source>
        <translation>Températures que deux objets peuvent avoir ensemble, quoi que fassent les autres. Glisser un point, ou double-cliquer, pour fixer leurs consignes.</translation>
    </message>
    <message>
        <source>few poses</source>
        <translation>peu de poses</translation>
    </message>
    <message>
        <source>rare</source>
        <translation>rare</translation>
    </message>
    <message>
        <source>Some pose has both, found by search; none of the poses that were counted does.</source>
        <translation>Une pose a les deux, trouvée par recherche ; aucune des poses comptées ne les a.</translation>
    </message>
    <message>
        <source>many (log)</source>
        <translation>beaucoup (log)</translation>
    </message>
    <message>
        <source>Share of the workspace&apos;s poses at which the pair settles there, on a logarithmic scale. Where it is small, the pair asks for a pose that is hard to keep.</source>
        <translation>Part des poses de l’espace de travail où la paire se stabilise là, en échelle logarithmique. Là où elle est faible, la paire demande une pose difficile à tenir.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Write each map as a table (CSV) and as a picture (PNG).</source>
        <translation>Écrire chaque carte en table (CSV) et en image (PNG).</translation>
    </message>
</context>
<context>
    <name>bask::ParameterForm</name>
    <message>
        <source>automatic</source>
        <translation>automatique</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1 : %2 au lieu de %3</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1 : automatique</translation>
    </message>
</context>
<context>
    <name>bask::PickedPanel</name>
    <message>
        <source>For each object at this point: its view factor, the temperature that it settles at, and how fast that rises along its arrow.</source>
        <translation>Pour chaque objet en ce point : son facteur de forme, la température où il se stabilise, et de combien elle monte le long de sa flèche.</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>Partir d’ici</translation>
    </message>
    <message>
        <source>Runs start at this point.</source>
        <translation>Les essais partent de ce point.</translation>
    </message>
    <message>
        <source>Runs cannot start at this point: %1.</source>
        <translation>Les essais ne peuvent partir de ce point : %1.</translation>
    </message>
</context>
<context>
    <name>bask::PictureDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As the view: %1 × %2</source>
        <translation>Comme la vue : %1 × %2</translation>
    </message>
    <message>
        <source>Twice the view: %1 × %2</source>
        <translation>Deux fois la vue : %1 × %2</translation>
    </message>
    <message>
        <source>Screen: %1 × %2</source>
        <translation>Écran : %1 × %2</translation>
    </message>
    <message>
        <source>A4 across at 300 dpi: %1 × %2</source>
        <translation>A4 en largeur à 300 ppp : %1 × %2</translation>
    </message>
    <message>
        <source>A4 upright at 300 dpi: %1 × %2</source>
        <translation>A4 en hauteur à 300 ppp : %1 × %2</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>Choisir l’emplacement…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer l’image</translation>
    </message>
    <message>
        <source>Save the animation</source>
        <translation>Enregistrer l’animation</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>Dossier des images</translation>
    </message>
</context>
<context>
    <name>bask::PlotPlace</name>
    <message>
        <source>Take the cursor away</source>
        <translation>Retirer le curseur</translation>
    </message>
    <message>
        <source>On the right axis</source>
        <translation>Sur l’axe de droite</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>Put back into the page</source>
        <translation>Remettre dans la page</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>Fenêtre à part</translation>
    </message>
    <message>
        <source>This plot is in a window of its own.</source>
        <translation>Cette courbe est dans une fenêtre à part.</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Remettre</translation>
    </message>
    <message>
        <source>Put the plot back: %1</source>
        <translation>Remettre la courbe : %1</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>Exporter ce qui est affiché</translation>
    </message>
    <message>
        <source>Figure (PDF)…</source>
        <translation>Figure (PDF)…</translation>
    </message>
    <message>
        <source>Figure (SVG)…</source>
        <translation>Figure (SVG)…</translation>
    </message>
    <message>
        <source>Figure (PNG)…</source>
        <translation>Figure (PNG)…</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>Tableau (CSV)…</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Mesurer à partir d’ici</translation>
    </message>
</context>
<context>
    <name>bask::PlotWindowsControl</name>
    <message>
        <source>Rig %1: %2</source>
        <comment>SIMULATED or LIVE, and the state of the run</comment>
        <translation>Banc %1 : %2</translation>
    </message>
</context>
<context>
    <name>bask::ProblemDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>This is all that the report has. Write at the top what happened and what you expected, take out what nobody should see, save it, and give it to whoever looks after your Bask. Nothing is sent.</source>
        <translation>Voici tout ce que contient le rapport. Écrivez en haut ce qui s’est passé et ce que vous attendiez, retirez ce que personne ne doit voir, enregistrez-le et donnez-le à la personne qui s’occupe de votre Bask. Rien n’est envoyé.</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>Le rapport</translation>
    </message>
    <message>
        <source>What happened:</source>
        <translation>Ce qui s’est passé :</translation>
    </message>
    <message>
        <source>What was expected:</source>
        <translation>Ce qui était attendu :</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Enregistrer…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>bask::ProgramQuestion</name>
    <message>
        <source>Program of a device</source>
        <translation>Programme d’un appareil</translation>
    </message>
    <message>
        <source>May Bask start this program on this computer?</source>
        <translation>Bask peut-il lancer ce programme sur cet ordinateur ?</translation>
    </message>
    <message>
        <source>It starts these files:</source>
        <translation>Elle lance ces fichiers&#xa0;:</translation>
    </message>
    <message>
        <source>It can do whatever you can do on this computer, and it moves or heats the device. Confirm only what you know. You are asked again when one of these files changes.</source>
        <translation>Il peut faire tout ce que vous pouvez faire sur cet ordinateur, et il fait bouger ou chauffer l’appareil. Ne confirmez que ce que vous connaissez. On vous le redemandera quand l’un de ces fichiers changera.</translation>
    </message>
    <message>
        <source>Allow it</source>
        <translation>L’autoriser</translation>
    </message>
</context>
<context>
    <name>bask::Question</name>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>bask::ReachBar</name>
    <message>
        <source>Reachable temperatures</source>
        <translation>Températures atteignables</translation>
    </message>
    <message>
        <source>The range is being worked out.</source>
        <translation>La plage est en cours de calcul.</translation>
    </message>
    <message>
        <source>Target %1. Here it can be held between %2 and %3; with nothing but the source in view, up to %4.</source>
        <translation>Consigne&#xa0;%1. Ici, elle peut être tenue entre&#xa0;%2 et&#xa0;%3&#xa0;; avec la source seule en vue, jusqu’à&#xa0;%4.</translation>
    </message>
</context>
<context>
    <name>bask::ReachMap</name>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>%1 à l’intérieur</translation>
    </message>
    <message>
        <source>%1 outside</source>
        <translation>%1 à l’extérieur</translation>
    </message>
    <message>
        <source>Temperatures that %1 and %2 can have together</source>
        <translation>Températures que %1 et %2 peuvent avoir ensemble</translation>
    </message>
    <message>
        <source>Targets %1 and %2: %3</source>
        <translation>Consignes %1 et %2 : %3</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: some pose has both</source>
        <translation>%1 à %2 et %3 à %4 : une pose a les deux</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: no pose has both</source>
        <translation>%1 à %2 et %3 à %4 : aucune pose n’a les deux</translation>
    </message>
</context>
<context>
    <name>bask::ReadingPanel</name>
    <message>
        <source>Temperature of %1</source>
        <translation>Température de %1</translation>
    </message>
    <message>
        <source>Temperatures by</source>
        <translation>Températures par</translation>
    </message>
    <message>
        <source>The pose of the thermal camera is not known, so it reads nothing: set it up.</source>
        <translation>La pose de la caméra thermique n’est pas connue, elle ne lit donc rien&#xa0;: configurez-la.</translation>
    </message>
    <message>
        <source>Sensor on the object</source>
        <translation>Capteur sur l’objet</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>Caméra thermique</translation>
    </message>
    <message>
        <source>Sensor, checked by the thermal camera</source>
        <translation>Capteur, vérifié par la caméra thermique</translation>
    </message>
</context>
<context>
    <name>bask::Recipe</name>
    <message>
        <source>Wait</source>
        <translation>Attente</translation>
    </message>
    <message>
        <source>all have been settled for %1</source>
        <translation>tous sont stabilisés depuis %1</translation>
    </message>
    <message>
        <source>%1 have passed</source>
        <translation>écoulement de %1</translation>
    </message>
    <message>
        <source>%1 is at %2 or above</source>
        <translation>%1 est à %2 ou plus</translation>
    </message>
    <message>
        <source>%1 is at %2 or below</source>
        <translation>%1 est à %2 ou moins</translation>
    </message>
    <message>
        <source>To come</source>
        <translation>À venir</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminée</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>Non atteinte</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échouée</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêtée</translation>
    </message>
    <message>
        <source>The recipe is done.</source>
        <translation>La recette est terminée.</translation>
    </message>
    <message>
        <source>The recipe has ended: not every step was done.</source>
        <translation>La recette a pris fin : toutes les étapes n’ont pas abouti.</translation>
    </message>
    <message>
        <source>The recipe was stopped.</source>
        <translation>La recette a été arrêtée.</translation>
    </message>
    <message>
        <source>The recipe has ended, since the rig or the experiment was taken in hand.</source>
        <translation>La recette a pris fin : quelqu’un a repris le banc ou l’expérience en main.</translation>
    </message>
    <message>
        <source>The recipe was ended by an alarm.</source>
        <translation>Une alarme a mis fin à la recette.</translation>
    </message>
    <message>
        <source>The recipe was ended by a fault.</source>
        <translation>Un défaut a mis fin à la recette.</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>En pause</translation>
    </message>
</context>
<context>
    <name>bask::RecipeControl</name>
    <message>
        <source>A recipe is on, step %1 of %2. It arms, moves and heats by itself.</source>
        <translation>Une recette est en cours, étape %1 sur %2. Elle arme, déplace et chauffe d’elle-même.</translation>
    </message>
    <message>
        <source>Open a recipe</source>
        <translation>Ouvrir une recette</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Recettes (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Recettes (*.json)</translation>
    </message>
    <message>
        <source>A recipe is on. Stop it before another one is opened.</source>
        <translation>Une recette est en cours. Arrêtez-la avant d’en ouvrir une autre.</translation>
    </message>
    <message>
        <source>Show the recipe</source>
        <translation>Voir la recette</translation>
    </message>
    <message>
        <source>Unsaved recipe</source>
        <translation>Recette non enregistrée</translation>
    </message>
    <message>
        <source>The recipe was changed and not saved.</source>
        <translation>La recette a été modifiée et n’est pas enregistrée.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Abandonner les modifications</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>Enregistrer la recette</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Add a run of an experiment</source>
        <translation>Ajouter un essai d’une expérience</translation>
    </message>
    <message>
        <source>Experiments (*.json);;All files (*)</source>
        <translation>Expériences (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Step %1 is for another rig than the present one: a recipe runs on one rig, which has been looked at.</source>
        <translation>L’étape %1 est pour un autre banc que celui-ci : une recette s’exécute sur un seul banc, qui a été vérifié.</translation>
    </message>
    <message>
        <source>%1. %2 until %3</source>
        <translation>%1. %2 jusqu’à : %3</translation>
    </message>
    <message>
        <source>%1. %2 until %3, at most %4</source>
        <translation>%1. %2 jusqu’à : %3, au plus %4</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>Démarrer la recette</translation>
    </message>
    <message>
        <source>It takes at most %1 and its retreats:</source>
        <translation>Elle dure au plus %1, retraits en sus :</translation>
    </message>
    <message>
        <source>This rig is real: the robot moves and the source heats, again and again and by itself. Is everybody and everything out of the way for so long? An alarm, a hold or a stop ends the recipe.</source>
        <translation>Ce banc est réel : le robot bouge et la source chauffe, encore et encore et sans personne. Tout le monde et tout est-il à l’écart pour aussi longtemps ? Une alarme, une pause ou un arrêt met fin à la recette.</translation>
    </message>
    <message>
        <source>An alarm, a hold or a stop ends the recipe.</source>
        <translation>Une alarme, une pause ou un arrêt met fin à la recette.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Something was changed meanwhile: start the recipe once more.</source>
        <translation>Quelque chose a changé entre-temps : démarrez la recette à nouveau.</translation>
    </message>
    <message>
        <source>The experiment has unsaved edits.</source>
        <translation>L’expérience a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>The source is heated by hand: a recipe cannot switch it off between its steps.</source>
        <translation>La source est chauffée à la main : une recette ne peut pas l’éteindre entre ses étapes.</translation>
    </message>
    <message>
        <source>Its run is held, not ended: nothing but a person resumes or stops it now.</source>
        <translation>Son essai est en pause, non terminé : seule une personne le reprend ou l’arrête désormais.</translation>
    </message>
    <message>
        <source>Its steps allow the real rig more than now:</source>
        <translation>Ses étapes permettent au banc réel plus que maintenant :</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>Robot, source, objets et capteurs le supportent-ils ?</translation>
    </message>
</context>
<context>
    <name>bask::RecipePanel</name>
    <message>
        <source>Run %1</source>
        <translation>Essai %1</translation>
    </message>
    <message>
        <source>%1; otherwise on with the next</source>
        <translation>%1 ; sinon, passer à la suivante</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Étape %1 sur %2</translation>
    </message>
    <message>
        <source>%1 of at most %2</source>
        <translation>%1 sur %2 au plus</translation>
    </message>
    <message>
        <source>running, %1</source>
        <translation>essai en cours, %1</translation>
    </message>
    <message>
        <source>waiting, %1</source>
        <translation>attente, %1</translation>
    </message>
    <message>
        <source>heat off, retreat</source>
        <translation>chauffage coupé, retrait</translation>
    </message>
    <message>
        <source>getting ready</source>
        <translation>préparation</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Experiments that are run one after another, with waits. Add a step or open a recipe.</source>
        <translation>Des expériences l’une après l’autre, avec des attentes. Ajoutez une étape ou ouvrez une recette.</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at most %1</source>
        <translation>
            <numerusform>%n étape, %1 au plus</numerusform>
            <numerusform>%n étapes, %1 au plus</numerusform>
        </translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>pas encore enregistrée</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modifiée</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>New recipe</source>
        <translation>Nouvelle recette</translation>
    </message>
    <message>
        <source>Open a recipe…</source>
        <translation>Ouvrir une recette…</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Save the recipe as…</source>
        <translation>Enregistrer la recette sous…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>A run of the open experiment</source>
        <translation>Un essai de l’expérience ouverte</translation>
    </message>
    <message>
        <source>A run of an experiment from a file…</source>
        <translation>Un essai d’une expérience d’un fichier…</translation>
    </message>
    <message>
        <source>A wait</source>
        <translation>Une attente</translation>
    </message>
    <message>
        <source>A wait until an object has cooled</source>
        <translation>Une attente jusqu’à ce qu’un objet ait refroidi</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Modifier…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>Démarrer la recette</translation>
    </message>
    <message>
        <source>Stop after this step</source>
        <translation>Arrêter après cette étape</translation>
    </message>
    <message>
        <source>Stop the recipe</source>
        <translation>Arrêter la recette</translation>
    </message>
    <message>
        <source>Look at the run</source>
        <translation>Voir l’essai</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>Fichier de la recette</translation>
    </message>
    <message>
        <source>A new recipe, another one, or this one under another name</source>
        <translation>Une nouvelle recette, une autre, ou celle-ci sous un autre nom</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>Enregistrer la recette</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>Ajouter une étape</translation>
    </message>
    <message>
        <source>Add a step after the chosen one</source>
        <translation>Ajouter une étape après celle qui est choisie</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>Modifier l’étape</translation>
    </message>
    <message>
        <source>Its condition, its longest time, and what comes if that passes (Enter)</source>
        <translation>Sa condition, sa durée maximale et ce qui suit si elle est dépassée (Entrée)</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>Supprimer l’étape</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>Monter l’étape</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>Descendre l’étape</translation>
    </message>
    <message>
        <source>Says what it will do, and asks</source>
        <translation>Dit ce qu’elle va faire, et demande</translation>
    </message>
    <message>
        <source>The step under way is the last one</source>
        <translation>L’étape en cours est la dernière</translation>
    </message>
    <message>
        <source>Heat off, retreat, and nothing more is begun</source>
        <translation>Chauffage coupé, retrait, et plus rien ne commence</translation>
    </message>
    <message>
        <source>The recording of the chosen step, on the Review page</source>
        <translation>L’enregistrement de l’étape choisie, sur la page Relecture</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>Étapes de la recette</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Étape</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Écoulé</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
</context>
<context>
    <name>bask::RecipeStepDialog</name>
    <message>
        <source>Run %1</source>
        <translation>Essai %1</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>Attente</translation>
    </message>
    <message>
        <source>All objects have settled</source>
        <translation>Tous les objets sont stabilisés</translation>
    </message>
    <message>
        <source>A time has passed</source>
        <translation>Un temps s’est écoulé</translation>
    </message>
    <message>
        <source>An object is so hot or hotter</source>
        <translation>Un objet est aussi chaud ou plus chaud</translation>
    </message>
    <message>
        <source>An object is so cold or colder</source>
        <translation>Un objet est aussi froid ou plus froid</translation>
    </message>
    <message>
        <source>End the recipe</source>
        <translation>Mettre fin à la recette</translation>
    </message>
    <message>
        <source>Go on with the next step</source>
        <translation>Passer à l’étape suivante</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>Jusqu’à</translation>
    </message>
    <message>
        <source>For</source>
        <translation>Pendant</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Otherwise</source>
        <translation>Sinon</translation>
    </message>
    <message>
        <source>Where the condition does not come in time, or the run cannot be begun. An alarm, a fault or a person&apos;s stop always ends the recipe.</source>
        <translation>Si la condition n’est pas atteinte à temps ou si l’essai ne peut pas commencer. Une alarme, un défaut ou l’arrêt par une personne met toujours fin à la recette.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>bask::RecoveryOffer</name>
    <message>
        <source>Bask ended before changes of “%1” were saved. They are kept as they were on %2.</source>
        <translation>Bask s’est arrêté avant l’enregistrement de modifications de «&#xa0;%1&#xa0;». Elles sont gardées dans leur état du %2.</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
</context>
<context>
    <name>bask::ReplayView</name>
    <message>
        <source>3-D scene of the run: source, objects and their paths</source>
        <translation>Scène 3D de l’essai : source, objets et leurs trajets</translation>
    </message>
    <message>
        <source>Further traces and the scene</source>
        <translation>Autres courbes et scène</translation>
    </message>
    <message>
        <source>Laid over it:</source>
        <translation>Superposé :</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>Image thermique</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Comparaison</translation>
    </message>
    <message>
        <source>recorded run %1</source>
        <translation>essai enregistré %1</translation>
    </message>
    <message>
        <source>no recorded run</source>
        <translation>aucun essai enregistré</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>Exporter la figure</translation>
    </message>
    <message>
        <source>The temperatures of all runs as they are shown; other plots by their own menus</source>
        <translation>Les températures de tous les essais, telles qu’elles sont affichées ; les autres courbes par leurs propres menus</translation>
    </message>
</context>
<context>
    <name>bask::ResidualPlot</name>
    <message>
        <source>Residual against the number of harmonics</source>
        <translation>Résidu selon le nombre d’harmoniques</translation>
    </message>
    <message>
        <source>Distance between the imported outline and the Fourier outline. Click to choose a number of harmonics.</source>
        <translation>Distance entre le contour importé et le contour de Fourier. Cliquez pour choisir un nombre d’harmoniques.</translation>
    </message>
    <message>
        <source>Residual, mm: rms (line), largest (dashes)</source>
        <translation>Résidu, mm&#xa0;: efficace (trait), maximal (tirets)</translation>
    </message>
    <message>
        <source>harmonics</source>
        <translation>harmoniques</translation>
    </message>
</context>
<context>
    <name>bask::ReviewDesk</name>
    <message>
        <source>%1 was closed properly: its outcome is &quot;interrupted&quot; now.</source>
        <translation>%1 a été clôturée : son issue est maintenant « interrompu ».</translation>
    </message>
    <message numerus="yes">
        <source>It is shown already, or there are %n runs over the open one: take one away first.</source>
        <translation>
            <numerusform>Elle est déjà affichée, ou il y a %n essai superposé à celui qui est ouvert : retirez-en un d’abord.</numerusform>
            <numerusform>Elle est déjà affichée, ou il y a %n essais superposés à celui qui est ouvert : retirez-en un d’abord.</numerusform>
        </translation>
    </message>
    <message>
        <source>A run is armed or on. Objects can be changed once it has stopped.</source>
        <translation>Un essai est armé ou en cours. Les objets pourront être modifiés après son arrêt.</translation>
    </message>
    <message>
        <source>No object of the open experiment has the name and material of one of this run under the same source and environment.</source>
        <translation>Aucun objet de l’expérience ouverte n’a le nom et le matériau d’un objet de cet essai, sous la même source et dans le même milieu.</translation>
    </message>
    <message>
        <source>Start values taken from this run: %1</source>
        <translation>Valeurs de départ reprises de cet essai : %1</translation>
    </message>
    <message>
        <source>List of runs is up to date</source>
        <translation>La liste des essais est à jour</translation>
    </message>
</context>
<context>
    <name>bask::ReviewPage</name>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is here.</source>
        <translation>Interrompu&#xa0;: l’enregistrement s’est terminé sans arrêt. Ce qui avait été écrit est ici.</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>Tous les objets sont stabilisés</translation>
    </message>
    <message>
        <source>Not all objects settled</source>
        <translation>Tous les objets ne sont pas stabilisés</translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>Terminé par un défaut</translation>
    </message>
    <message>
        <source>No session open</source>
        <translation>Aucune session ouverte</translation>
    </message>
    <message>
        <source>&amp;Open session…</source>
        <translation>&amp;Ouvrir une session…</translation>
    </message>
    <message>
        <source>Final values</source>
        <translation>Valeurs finales</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>Événements et notes</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Issue</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Régulateur</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Logiciel</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>RÉEL</translation>
    </message>
    <message>
        <source>Heat rates λ₁ in K/s</source>
        <translation>Coefficients thermiques λ₁ en K/s</translation>
    </message>
    <message>
        <source>Use as start values</source>
        <translation>Prendre comme départ</translation>
    </message>
    <message>
        <source>Controllers of the open experiment start with the identified rates, in the objects of the same name and material under the same source.</source>
        <translation>Les régulateurs de l’expérience ouverte partent des coefficients identifiés, pour les objets de même nom et de même matériau sous la même source.</translation>
    </message>
    <message>
        <source>Fitting the heat balance to the record…</source>
        <translation>Ajustement du bilan thermique à l’enregistrement…</translation>
    </message>
    <message>
        <source>Choose a recorded run in the list and press Enter, or open a file: its traces, events and metrics are shown here, and it can be played again.</source>
        <translation>Choisissez un essai enregistré dans la liste et appuyez sur Entrée, ou ouvrez un fichier : ses courbes, événements et indicateurs s’affichent ici, et l’essai peut être rejoué.</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is here.</source>
        <translation>Interrompu : l’enregistrement s’est terminé sans arrêt et a été clôturé plus tard. Ce qui avait été écrit est ici.</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicateurs</translation>
    </message>
    <message>
        <source>What is known of the run</source>
        <translation>Ce que l’on sait de l’essai</translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation>À propos de l’enregistrement</translation>
    </message>
    <message>
        <source>Heat rates</source>
        <translation>Coefficients thermiques</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xporter</translation>
    </message>
    <message>
        <source>Write this session as a report, as figures or for other programs</source>
        <translation>Écrire cette session comme rapport, comme figures ou pour d’autres programmes</translation>
    </message>
    <message>
        <source>Report (&amp;PDF)…</source>
        <translation>Rapport (&amp;PDF)…</translation>
    </message>
    <message>
        <source>Report (&amp;HTML)…</source>
        <translation>Rapport (&amp;HTML)…</translation>
    </message>
    <message>
        <source>&amp;Figures (PNG, SVG, PDF)…</source>
        <translation>&amp;Figures (PNG, SVG, PDF)…</translation>
    </message>
    <message>
        <source>Tables (&amp;CSV)…</source>
        <translation>Tableaux (&amp;CSV)…</translation>
    </message>
    <message>
        <source>&amp;NeXus (HDF5)…</source>
        <translation>&amp;NeXus (HDF5)…</translation>
    </message>
    <message>
        <source>&amp;VTK, for ParaView…</source>
        <translation>&amp;VTK, pour ParaView…</translation>
    </message>
    <message>
        <source>Metrics, final values and heat rates are being computed from all samples: %1 %</source>
        <translation>Indicateurs, valeurs finales et coefficients thermiques se calculent sur tous les échantillons : %1 %</translation>
    </message>
    <message>
        <source>No metrics, final values and heat rates: the recording cannot be read to its end.</source>
        <translation>Ni indicateurs, ni valeurs finales, ni coefficients thermiques : l’enregistrement ne peut pas être lu jusqu’au bout.</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message>
        <source>Ended by STOP</source>
        <translation>Terminé par STOP</translation>
    </message>
    <message>
        <source>Opened while it was being recorded: open it again to see the rest.</source>
        <translation>Ouvert pendant son enregistrement : rouvrez-le pour voir la suite.</translation>
    </message>
    <message>
        <source>The record tells the losses of %1, but not what of them is radiated and what the air takes. State the air on the Objects page, or record wider temperatures.</source>
        <translation>L’enregistrement donne les pertes de %1, mais pas ce qui en est rayonné et ce que l’air prend. Indiquez l’air à la page Objets, ou enregistrez des températures plus étendues.</translation>
    </message>
    <message>
        <source>Losses, of radiation and air</source>
        <translation>Pertes par rayonnement et par l’air</translation>
    </message>
    <message>
        <source>There is nothing to play: no run is open. Choose one in the list.</source>
        <translation>Il n’y a rien à lire&#xa0;: aucun essai n’est ouvert. Choisissez-en un dans la liste.</translation>
    </message>
    <message>
        <source>Open as new experiment</source>
        <translation>Ouvrir comme nouvelle</translation>
    </message>
    <message>
        <source>Opens what was run here, objects, source, targets and limits as the recording has them, as a new experiment without a file.</source>
        <translation>Ouvre ce qui a été exécuté ici, objets, source, consignes et limites tels qu’ils sont dans l’enregistrement, comme une nouvelle expérience sans fichier.</translation>
    </message>
    <message>
        <source>Tables with &amp;all digits (CSV)…</source>
        <translation>T&amp;ableaux avec tous les chiffres (CSV)…</translation>
    </message>
    <message>
        <source>Not verified: %1</source>
        <translation>Non vérifié&#xa0;: %1</translation>
    </message>
    <message>
        <source>No object shades another</source>
        <translation>Aucun objet ne fait d’ombre à un autre</translation>
    </message>
    <message>
        <source>At most %1 % of an object&apos;s view factor is taken by the others</source>
        <translation>Au plus %1&#xa0;% du facteur de forme d’un objet sont pris par les autres</translation>
    </message>
    <message>
        <source>Being verified…</source>
        <translation>Vérification en cours…</translation>
    </message>
    <message>
        <source>Head of the hash chain: %1</source>
        <translation>Tête de la chaîne de hachage&#xa0;: %1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>Coefficients thermiques au démarrage</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>Ombre</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>%1, recorded until %2</source>
        <comment>two times since Start</comment>
        <translation>%1, enregistré jusqu’à %2</translation>
    </message>
</context>
<context>
    <name>bask::RigDevices</name>
    <message>
        <source>Simulated rig</source>
        <translation>Banc simulé</translation>
    </message>
    <message>
        <source>No device moves or heats. The real rig&apos;s set-up is kept for later.</source>
        <translation>Aucun appareil ne bouge ni ne chauffe. Le réglage du banc réel est gardé pour plus tard.</translation>
    </message>
    <message>
        <source>Real rig</source>
        <translation>Banc réel</translation>
    </message>
    <message>
        <source>The devices below</source>
        <translation>Les appareils ci-dessous</translation>
    </message>
    <message>
        <source>Name of the rig</source>
        <translation>Nom du banc</translation>
    </message>
    <message>
        <source>Open rig…</source>
        <translation>Ouvrir un banc…</translation>
    </message>
    <message>
        <source>Take the devices from a rig file</source>
        <translation>Prendre les appareils dans un fichier de banc</translation>
    </message>
    <message>
        <source>Save rig…</source>
        <translation>Enregistrer le banc…</translation>
    </message>
    <message>
        <source>Write these devices to a rig file, for other experiments</source>
        <translation>Écrire ces appareils dans un fichier de banc, pour d’autres expériences</translation>
    </message>
    <message>
        <source>Console…</source>
        <translation>Console…</translation>
    </message>
    <message>
        <source>What goes over the links to the devices</source>
        <translation>Ce qui passe par les liaisons avec les appareils</translation>
    </message>
</context>
<context>
    <name>bask::RigPage</name>
    <message>
        <source>The rig was set up for %1 objects, and there are %2: check the thermometer&apos;s channels.</source>
        <translation>Le banc était réglé pour %1 objets, et il y en a %2 : vérifiez les voies du thermomètre.</translation>
    </message>
    <message>
        <source>A run is armed or on: it has the robot and the heat.</source>
        <translation>Un essai est armé ou en cours : il dispose du robot et du chauffage.</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Press Reset first.</source>
        <translation>Un arrêt ou un défaut est verrouillé. Appuyez d’abord sur Réinitialiser.</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>Source and limits</source>
        <translation>Source et limites</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>Chauffage</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>Élever une limite du banc réel</translation>
    </message>
    <message>
        <source>This allows the rig more than before. Do robot, source, objects and sensors bear it?</source>
        <translation>Le banc pourra aller plus loin qu’avant. Robot, source, objets et capteurs le supportent-ils ?</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>Élever la limite</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>Limites du banc réel</translation>
    </message>
    <message>
        <source>This rig is allowed more than now, or than is usual:</source>
        <translation>Ce banc pourra plus que maintenant, ou que d’habitude :</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>Robot, source, objets et capteurs le supportent-ils ?</translation>
    </message>
    <message>
        <source>Use these limits</source>
        <translation>Utiliser ces limites</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Home the robot or confirm its place, then press Reset.</source>
        <translation>Un arrêt ou un défaut est verrouillé. Lancez la prise d’origine du robot ou confirmez sa position, puis appuyez sur Réinitialiser.</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Reset is possible when its cause is over.</source>
        <translation>Un arrêt ou un défaut est verrouillé. Réinitialiser est possible quand sa cause est terminée.</translation>
    </message>
</context>
<context>
    <name>bask::RigPanel</name>
    <message>
        <source>Follow the source &amp;during runs</source>
        <translation>Suivre la source &amp;pendant les essais</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>Plu&amp;sieurs poses</translation>
    </message>
    <message>
        <source>&amp;Use this pose</source>
        <translation>&amp;Utiliser cette pose</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>Un essai est armé ou en cours, ou un arrêt n’est pas réinitialisé. Mesurez après.</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Telle que saisie</translation>
    </message>
    <message>
        <source>By the end-effector&apos;s markers, in the robot&apos;s base. Several poses of the robot are surer than one.</source>
        <translation>Par les marqueurs de l’effecteur, dans la base du robot. Plusieurs poses du robot sont plus sûres qu’une seule.</translation>
    </message>
    <message>
        <source>By the markers on the source and on the end-effector, seen in the same pictures.</source>
        <translation>Par les marqueurs de la source et de l’effecteur, vus sur les mêmes images.</translation>
    </message>
    <message>
        <source>Calibrate the camera first.</source>
        <translation>Étalonnez d’abord la caméra.</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>Vé&amp;rifier</translation>
    </message>
    <message>
        <source>Checked at another pose: %1 and %2 off; up to %3 and %4 was to be expected.</source>
        <translation>Vérifiée à une autre pose : écart de %1 et %2 ; jusqu’à %3 et %4 étaient à attendre.</translation>
    </message>
    <message>
        <source>Fr&amp;om here</source>
        <translation>D’&amp;ici</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Utilisée</translation>
    </message>
    <message>
        <source>List the markers on the end-effector first.</source>
        <translation>Listez d’abord les marqueurs de l’effecteur.</translation>
    </message>
    <message>
        <source>Markers on the rig</source>
        <translation>Marqueurs sur le montage</translation>
    </message>
    <message>
        <source>Moves the robot to a pose that was not measured, compares where the markers are with where they should be, and moves back.</source>
        <translation>Amène le robot à une pose qui n’a pas été mesurée, compare où sont les marqueurs avec où ils devraient être, et revient.</translation>
    </message>
    <message>
        <source>No picture from the camera.</source>
        <translation>Aucune image de la caméra.</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>Non mesurée</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Montage</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>C’est à %1 et %2 de la place que lui donne l’expérience.</translation>
    </message>
    <message>
        <source>The camera stands at %1, measured %2.</source>
        <translation>La caméra se trouve en %1, mesuré %2.</translation>
    </message>
    <message>
        <source>The camera stands at %1.</source>
        <translation>La caméra se trouve en %1.</translation>
    </message>
    <message>
        <source>The camera tells the controllers where the source is. Takes markers on the source, a calibrated camera and its place.</source>
        <translation>La caméra dit aux régulateurs où est la source. Il faut des marqueurs sur la source, une caméra étalonnée et sa place.</translation>
    </message>
    <message>
        <source>The end-effector in the source: %1.</source>
        <translation>L’effecteur dans la source : %1.</translation>
    </message>
    <message>
        <source>The robot did not move: nothing was checked.</source>
        <translation>Le robot n’a pas bougé : rien n’a été vérifié.</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>Le robot va à quelques poses de son espace de travail, jamais plus près de la source, et revient. Tenez-vous à l’écart.</translation>
    </message>
    <message>
        <source>The robot says where it is to %1 and %2 (one standard deviation).</source>
        <translation>Le robot dit où il est à %1 et %2 près (un écart-type).</translation>
    </message>
    <message>
        <source>The robot stays where it is.</source>
        <translation>Le robot reste où il est.</translation>
    </message>
    <message>
        <source>The source in the robot&apos;s base: %1.</source>
        <translation>La source dans la base du robot&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The source lies at %1, measured %2.</source>
        <translation>La source se trouve en %1, mesuré %2.</translation>
    </message>
    <message>
        <source>The source lies at %1.</source>
        <translation>La source se trouve en %1.</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>Utiliser cette p&amp;lace</translation>
    </message>
    <message>
        <source>What it sees at the source is known to ±%1 and ±%2 (two standard deviations), by %3 pose(s) of the robot; residual %4 px.</source>
        <translation>Ce qu’elle voit à la source est connu à ±%1 et ±%2 (deux écarts-types), par %3 pose(s) du robot ; résidu %4 px.</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>Place de la caméra</translation>
    </message>
    <message>
        <source>Where the source is</source>
        <translation>Place de la source</translation>
    </message>
</context>
<context>
    <name>bask::RunDifferences</name>
    <message>
        <source>all %1</source>
        <comment>objects of a run; their target</comment>
        <translation>tous à %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>objects, and their one target</comment>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>bask::RunLabelWords</name>
    <message>
        <source>operator %1</source>
        <translation>opérateur %1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>échantillon %1</translation>
    </message>
    <message>
        <source>batch %1</source>
        <translation>lot %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between operator, sample and batch</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>note, its operator</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>The run had been stopped; what followed is not recorded to its end.</source>
        <translation>L’essai avait été arrêté&#xa0;; ce qui a suivi n’est pas enregistré jusqu’au bout.</translation>
    </message>
    <message>
        <source>Faster than real time: %1 (min:s) of the simulated rig in %2 by the clock</source>
        <translation>Plus vite que le temps réel : %1 (min:s) du banc simulé en %2 d’après l’horloge</translation>
    </message>
</context>
<context>
    <name>bask::RunPage</name>
    <message>
        <source>Sensor lost</source>
        <translation>Capteur perdu</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprise</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêt</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Stabilisé</translation>
    </message>
    <message>
        <source>New targets</source>
        <translation>Nouvelles consignes</translation>
    </message>
    <message>
        <source>New gains</source>
        <translation>Nouveaux gains</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Compromise</source>
        <translation>Compromis</translation>
    </message>
    <message>
        <source>Source lost</source>
        <translation>Source perdue</translation>
    </message>
    <message>
        <source>Source back</source>
        <translation>Source revenue</translation>
    </message>
    <message>
        <source>Sensor back</source>
        <translation>Capteur de retour</translation>
    </message>
    <message>
        <source>Behind by %1 — jump to live</source>
        <translation>En retard de&#xa0;%1 — revenir au direct</translation>
    </message>
    <message>
        <source>Jump to live</source>
        <translation>Revenir au direct</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>Suivre le direct</translation>
    </message>
    <message>
        <source>Keep the newest samples in view. Zooming or dragging a plot turns it off; no sample is lost.</source>
        <translation>Garder les derniers échantillons en vue. Zoomer ou déplacer une courbe y met fin&#xa0;; aucun échantillon n’est perdu.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>tout l’essai</translation>
    </message>
    <message>
        <source>last minute</source>
        <translation>dernière minute</translation>
    </message>
    <message>
        <source>last 5 minutes</source>
        <translation>5 dernières minutes</translation>
    </message>
    <message>
        <source>last 30 minutes</source>
        <translation>30 dernières minutes</translation>
    </message>
    <message>
        <source>Stretch of time shown while following</source>
        <translation>Durée montrée pendant le suivi</translation>
    </message>
    <message>
        <source>Show the newest samples again and follow them.</source>
        <translation>Montrer de nouveau les derniers échantillons et les suivre.</translation>
    </message>
    <message>
        <source>Further traces</source>
        <translation>Autres courbes</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Look along −z of the source, from above.</source>
        <translation>Regarder selon −z de la source, d’en haut.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Look along x of the source, from the side.</source>
        <translation>Regarder selon x de la source, de côté.</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Look from above at an angle.</source>
        <translation>Regarder d’en haut, en biais.</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Vue&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>3-D scene: source, objects and their paths</source>
        <translation>Scène 3D&#xa0;: source, objets et trajectoires</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Press N, type, Enter: noted at this moment of the run</source>
        <translation>N, texte, Entrée&#xa0;: noté à cet instant de l’essai</translation>
    </message>
    <message>
        <source>Note at this moment of the run</source>
        <translation>Note à cet instant de l’essai</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Record the note with the present time.</source>
        <translation>Enregistrer la note à l’instant présent.</translation>
    </message>
    <message>
        <source>Add the note</source>
        <translation>Ajouter la note</translation>
    </message>
    <message>
        <source>Simulation speed</source>
        <translation>Vitesse de simulation</translation>
    </message>
    <message>
        <source>Simulated seconds a second; only on the simulated rig.</source>
        <translation>Secondes simulées par seconde&#xa0;; banc simulé seulement.</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>accélération</translation>
    </message>
    <message>
        <source>angular acceleration</source>
        <translation>accélération angulaire</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>distance à la source</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>espace de travail %1</translation>
    </message>
    <message>
        <source>No limit holds the robot back.</source>
        <translation>Aucune limite ne retient le robot.</translation>
    </message>
    <message>
        <source>A limit holds the robot back.</source>
        <translation>Une limite retient le robot.</translation>
    </message>
    <message>
        <source>Held back by: %1</source>
        <translation>Retenu par : %1</translation>
    </message>
    <message>
        <source>Place UNKNOWN, what is drawn is %1.</source>
        <translation>Position INCONNUE, ce qui est dessiné date : %1.</translation>
    </message>
    <message>
        <source>The robot is not sure of its place.</source>
        <translation>Le robot n’est pas sûr de sa position.</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>Image thermique</translation>
    </message>
    <message>
        <source>present run</source>
        <translation>essai en cours</translation>
    </message>
    <message>
        <source>run of %1</source>
        <translation>essai de %1</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Prédit</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <comment>the name of an object, and how much of the source the others hide from it</comment>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>Shaded: %1</source>
        <translation>Ombre : %1</translation>
    </message>
    <message>
        <source>How much of the source the other objects hide: %1. The view factors count it.</source>
        <translation>Part de la source que les autres objets cachent : %1. Les facteurs de forme en tiennent compte.</translation>
    </message>
    <message>
        <source>The run as the simulated rig predicts it from where it starts: dotted behind the traces, dashed in the scene. Its band: %1 runs with other sensor noise; not material, air or source, which are as the experiment has them. It is kept with the recording.</source>
        <translation>L’essai tel que le banc simulé le prédit depuis son point de départ : en pointillé derrière les courbes, en tireté dans la scène. Sa bande : %1 essais avec un autre bruit des capteurs ; ni autre matériau, ni autre air, ni autre source, qui sont ceux de l’expérience. Il est gardé avec l’enregistrement.</translation>
    </message>
</context>
<context>
    <name>bask::RunReport</name>
    <message>
        <source>%1: %2</source>
        <comment>command: its values</comment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>, changing by a profile during the run</source>
        <translation>, variable selon un profil pendant l’essai</translation>
    </message>
    <message>
        <source>, tracked during the run</source>
        <translation>, suivie pendant l’essai</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Acquitter</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmes</translation>
    </message>
    <message>
        <source>Alarms, events, notes and commands</source>
        <translation>Alarmes, événements, notes et commandes</translation>
    </message>
    <message>
        <source>All objects settled.</source>
        <translation>Tous les objets sont stabilisés.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Areal heat capacity</source>
        <translation>Capacité thermique surfacique</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armer</translation>
    </message>
    <message>
        <source>By itself</source>
        <translation>Seule</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Étalonnage</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Clearance to the source&apos;s plane</source>
        <translation>Garde au plan de la source</translation>
    </message>
    <message>
        <source>Commanded speed</source>
        <translation>Vitesse commandée</translation>
    </message>
    <message>
        <source>Commanded speed of the end-effector as a share of its limits: %1 mm/s and %2 °/s.</source>
        <translation>Vitesse commandée de l’effecteur, en part de ses limites : %1 mm/s et %2 °/s.</translation>
    </message>
    <message>
        <source>Control from Start until Stop</source>
        <translation>Asservissement, du démarrage à l’arrêt</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Régulateur</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Définitions</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>Désarmer</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>Émittance de la source</translation>
    </message>
    <message>
        <source>Ended by a fault.</source>
        <translation>Terminé par un défaut.</translation>
    </message>
    <message>
        <source>Experiment without a title</source>
        <translation>Expérience sans titre</translation>
    </message>
    <message>
        <source>Feasibility of the targets</source>
        <translation>Faisabilité des consignes</translation>
    </message>
    <message>
        <source>Fourier contour, radius %1 mm</source>
        <translation>contour de Fourier, rayon %1 mm</translation>
    </message>
    <message>
        <source>Free axes</source>
        <translation>Axes libres</translation>
    </message>
    <message>
        <source>Gains at the start</source>
        <translation>Gains au départ</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>Source de chaleur</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is reported.</source>
        <translation>Interrompu : l’enregistrement s’est terminé sans arrêt. Ce qui avait été écrit est rapporté.</translation>
    </message>
    <message>
        <source>It was not computed.</source>
        <translation>Elle n’a pas été calculée.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Nature</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>RÉEL</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Indicateurs</translation>
    </message>
    <message>
        <source>Model of the source</source>
        <translation>Modèle de la source</translation>
    </message>
    <message>
        <source>Nearest that can be held</source>
        <translation>La plus proche tenable</translation>
    </message>
    <message>
        <source>No pose keeps the workspace and the clearance.</source>
        <translation>Aucune pose ne respecte l’espace de travail et la garde.</translation>
    </message>
    <message>
        <source>No samples were recorded: there are no traces, trajectories and metrics.</source>
        <translation>Aucun échantillon n’a été enregistré : il n’y a ni courbes, ni trajectoires, ni indicateurs.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>None was recorded.</source>
        <translation>Rien n’a été enregistré.</translation>
    </message>
    <message>
        <source>Not all objects settled.</source>
        <translation>Tous les objets ne sont pas stabilisés.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Issue</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Place on the end-effector</source>
        <translation>Place sur l’effecteur</translation>
    </message>
    <message>
        <source>Pose of the camera in the robot&apos;s base</source>
        <translation>Pose de la caméra dans la base du robot</translation>
    </message>
    <message>
        <source>Pose of the source</source>
        <translation>Pose de la source</translation>
    </message>
    <message>
        <source>Pose of the source in the robot&apos;s base</source>
        <translation>Pose de la source dans la base du robot</translation>
    </message>
    <message>
        <source>Range in the workspace</source>
        <translation>Plage dans l’espace de travail</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Enregistré par</translation>
    </message>
    <message>
        <source>Recorded on a real rig.</source>
        <translation>Enregistré sur un banc réel.</translation>
    </message>
    <message>
        <source>Report made at</source>
        <translation>Rapport établi le</translation>
    </message>
    <message>
        <source>Report made by</source>
        <translation>Rapport établi par</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Réinitialiser</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Échantillonnage</translation>
    </message>
    <message>
        <source>Session file</source>
        <translation>Fichier de session</translation>
    </message>
    <message>
        <source>Set temperature</source>
        <translation>Température de consigne</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>Head of the hash chain (bask verify --head)</source>
        <translation>Tête de la chaîne de hachage (bask verify --head)</translation>
    </message>
    <message>
        <source>Size of the session file</source>
        <translation>Taille du fichier de session</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>Limites de vitesse</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Start pose</source>
        <translation>Pose de départ</translation>
    </message>
    <message>
        <source>Steady, all together</source>
        <translation>Permanente, toutes ensemble</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Environnement</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Target at the start</source>
        <translation>Consigne au départ</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Consignes</translation>
    </message>
    <message>
        <source>Temperature (%1)</source>
        <translation>Température (%1)</translation>
    </message>
    <message>
        <source>The checksum is of the file without the log beside it.</source>
        <translation>La somme de contrôle est celle du fichier sans le journal à côté de lui.</translation>
    </message>
    <message>
        <source>The experiment has none: the pose of the source is as typed.</source>
        <translation>L’expérience n’en a pas : la pose de la source est celle saisie.</translation>
    </message>
    <message>
        <source>The rig was simulated: these are not measurements of a real one.</source>
        <translation>Le banc était simulé : ce ne sont pas des mesures d’un banc réel.</translation>
    </message>
    <message>
        <source>The targets cannot be held together, by the materials as given: %1.</source>
        <translation>Les consignes ne peuvent pas être tenues ensemble, d’après les matériaux donnés : %1.</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Temps (s)</translation>
    </message>
    <message>
        <source>Traces and trajectories</source>
        <translation>Courbes et trajectoires</translation>
    </message>
    <message>
        <source>View factor needed</source>
        <translation>Facteur de forme requis</translation>
    </message>
    <message>
        <source>Warning, trip</source>
        <translation>Avertissement, déclenchement</translation>
    </message>
    <message>
        <source>Trajectories of the objects</source>
        <translation>Trajectoires des objets</translation>
    </message>
    <message>
        <source>Trajectories of the objects&apos; centres over the source until Stop, from the ring to the dot, coloured by temperature; black: the source.</source>
        <translation>Trajectoires des centres des objets au-dessus de la source jusqu’à l’arrêt, de l’anneau au point, colorées selon la température ; en noir : la source.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>Espace de travail</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>Ajuster les capteurs</translation>
    </message>
    <message>
        <source>alarm, priority %1</source>
        <translation>alarme, priorité %1</translation>
    </message>
    <message>
        <source>as in the paper, without reflection</source>
        <translation>comme dans l’article, sans réflexion</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>telle que saisie</translation>
    </message>
    <message>
        <source>command</source>
        <translation>commande</translation>
    </message>
    <message>
        <source>date not known</source>
        <translation>date inconnue</translation>
    </message>
    <message>
        <source>disk, radius %1 mm</source>
        <translation>disque, rayon %1 mm</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>erreur inconnue</translation>
    </message>
    <message>
        <source>event</source>
        <translation>événement</translation>
    </message>
    <message>
        <source>every %1 s</source>
        <translation>toutes les %1 s</translation>
    </message>
    <message>
        <source>grey, with reflection</source>
        <translation>grise, avec réflexion</translation>
    </message>
    <message>
        <source>measured by the camera, %1</source>
        <translation>mesurée par la caméra, %1</translation>
    </message>
    <message>
        <source>no event was recorded</source>
        <translation>aucun événement enregistré</translation>
    </message>
    <message>
        <source>no samples were recorded</source>
        <translation>aucun échantillon enregistré</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>non étalonnée</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>offsets of the sensors %1</source>
        <translation>écarts des capteurs %1</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>page %1 sur %2</translation>
    </message>
    <message>
        <source>polygon, radius %1 mm</source>
        <translation>polygone, rayon %1 mm</translation>
    </message>
    <message>
        <source>seen along x of the source</source>
        <translation>vu le long de x de la source</translation>
    </message>
    <message>
        <source>seen along −z of the source</source>
        <translation>vu le long de −z de la source</translation>
    </message>
    <message>
        <source>simulated, seed %1</source>
        <translation>simulé, graine %1</translation>
    </message>
    <message>
        <source>surroundings %1</source>
        <translation>environnement %1</translation>
    </message>
    <message>
        <source>targets out of reach accepted</source>
        <translation>consignes hors d’atteinte acceptées</translation>
    </message>
    <message>
        <source>too cold</source>
        <translation>trop froide</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>trop chaude</translation>
    </message>
    <message>
        <source>within the range</source>
        <translation>dans la plage</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>sans nom</translation>
    </message>
    <message numerus="yes">
        <source>%1 (min:s), %n sample(s)</source>
        <translation>
            <numerusform>%1 (min:s), %n échantillon</numerusform>
            <numerusform>%1 (min:s), %n échantillons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels, fx = %2 px, fy = %3 px, %4, %n view(s)</source>
        <translation>
            <numerusform>%1 pixels, fx = %2 px, fy = %3 px, %4, %n vue</numerusform>
            <numerusform>%1 pixels, fx = %2 px, fy = %3 px, %4, %n vues</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarme</numerusform>
            <numerusform>%n alarmes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n trou</numerusform>
            <numerusform>%n trous</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s) of dictionary %1</source>
        <translation>
            <numerusform>%n marqueur du dictionnaire %1</numerusform>
            <numerusform>%n marqueurs du dictionnaire %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more row(s) are in the session file; bask export --csv lists them.</source>
        <translation>
            <numerusform>%n autre ligne est dans le fichier de session ; bask export --csv la donne.</numerusform>
            <numerusform>%n autres lignes sont dans le fichier de session ; bask export --csv les donne.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 mm/s and %2 °/s</source>
        <translation>%1 mm/s et %2 °/s</translation>
    </message>
    <message>
        <source>%1 px rms</source>
        <translation>%1 px rms</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Arrêté.</translation>
    </message>
    <message>
        <source>Ended by STOP.</source>
        <translation>Terminé par STOP.</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is reported.</source>
        <translation>Interrompu : l’enregistrement s’est terminé sans arrêt et a été clôturé plus tard. Ce qui avait été écrit est rapporté.</translation>
    </message>
    <message>
        <source>All targets can be held together, by the materials as given, at %1; margin %2 to the nearest limit (%3).</source>
        <translation>Toutes les consignes peuvent être tenues ensemble, avec les matériaux indiqués, en %1 ; marge de %2 jusqu’à la limite la plus proche (%3).</translation>
    </message>
    <message>
        <source>Safety limits</source>
        <translation>Limites de sécurité</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Air</translation>
    </message>
    <message>
        <source>natural convection, by correlation</source>
        <translation>convection naturelle, par corrélation</translation>
    </message>
    <message>
        <source>convection h = %1 W/(m² K)</source>
        <translation>convection h = %1 W/(m² K)</translation>
    </message>
    <message>
        <source>convection not known, not counted</source>
        <translation>convection inconnue, non comptée</translation>
    </message>
    <message>
        <source>Mean view factor</source>
        <translation>Facteur de forme moyen</translation>
    </message>
    <message>
        <source>Without shade</source>
        <translation>Sans ombre</translation>
    </message>
    <message>
        <source>Taken by the others, mean</source>
        <translation>Pris par les autres, moyenne</translation>
    </message>
    <message>
        <source>Taken by the others, largest</source>
        <translation>Pris par les autres, maximum</translation>
    </message>
    <message>
        <source>Shade of the objects on one another, from Start until Stop</source>
        <translation>Ombre des objets les uns sur les autres, du démarrage à l’arrêt</translation>
    </message>
    <message>
        <source>Evenness of the source</source>
        <translation>Uniformité de la source</translation>
    </message>
    <message>
        <source>Fixture or shield</source>
        <translation>Support ou écran</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>on the end-effector: %1</source>
        <translation>sur l’effecteur&#xa0;: %1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base: %1</source>
        <translation>dans la base du robot&#xa0;: %1</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>caméra thermique</translation>
    </message>
    <message>
        <source>sensor, checked by the thermal camera</source>
        <translation>capteur, vérifié par la caméra thermique</translation>
    </message>
    <message>
        <source>sensor on the object</source>
        <translation>capteur sur l’objet</translation>
    </message>
    <message>
        <source>Temperature by</source>
        <translation>Température par</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Mesurée</translation>
    </message>
    <message>
        <source>By the camera, ± 2 standard uncertainties</source>
        <translation>Par la caméra, ± 2 incertitudes types</translation>
    </message>
    <message>
        <source>Largest difference across the face</source>
        <translation>Plus grand écart sur la face</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixels</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>non lu</translation>
    </message>
    <message>
        <source>The thermal camera at the last sample until Stop</source>
        <translation>La caméra thermique au dernier échantillon avant l’arrêt</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Échantillon</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>Lot</translation>
    </message>
    <message>
        <source>not told: the recording was altered</source>
        <translation>non indiquée&#xa0;: l’enregistrement a été modifié</translation>
    </message>
    <message>
        <source>This recording was altered after it had been recorded, so nothing here is proven; bask verify tells where.</source>
        <translation>Cet enregistrement a été modifié après coup&#xa0;: rien ici n’est donc prouvé&#xa0;; bask verify dit où.</translation>
    </message>
    <message>
        <source>zeroed %1</source>
        <translation>ajustés le %1</translation>
    </message>
    <message>
        <source>from Arm at %1; Start at %2</source>
        <translation>dès l’armement, %1 ; démarrage, %2</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulation</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>Coefficients thermiques au démarrage</translation>
    </message>
    <message>
        <source>%1 %2 (set point %3)</source>
        <comment>when: the source&apos;s temperature</comment>
        <translation>%1 %2 (consigne %3)</translation>
    </message>
    <message>
        <source>at Start</source>
        <translation>au démarrage</translation>
    </message>
    <message>
        <source>settled at %1 s</source>
        <translation>stabilisés à %1 s</translation>
    </message>
    <message>
        <source>at the end of control</source>
        <translation>à la fin de la régulation</translation>
    </message>
    <message>
        <source>Source in the run</source>
        <translation>Source pendant l’essai</translation>
    </message>
    <message>
        <source>λ₁ at Start (K/s)</source>
        <translation>λ₁ au démarrage (K/s)</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>d’après le matériau</translation>
    </message>
    <message>
        <source>λ₂ at Start (1/(K³ s))</source>
        <translation>λ₂ au démarrage (1/(K³ s))</translation>
    </message>
    <message>
        <source>Where from</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>given by the experiment</source>
        <translation>donnés par l’expérience</translation>
    </message>
    <message>
        <source>the material, made wrong</source>
        <translation>le matériau, faussés</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>le matériau</translation>
    </message>
    <message>
        <source>Heat rates with which the controller began</source>
        <translation>Coefficients thermiques avec lesquels le régulateur a commencé</translation>
    </message>
    <message>
        <source>± is the standard uncertainty of a material&apos;s value.</source>
        <translation>± est l’incertitude type d’une valeur du matériau.</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no simulated fault any more</comment>
        <translation>aucun</translation>
    </message>
    <message>
        <source>ended</source>
        <comment>a simulated fault</comment>
        <translation>terminé</translation>
    </message>
    <message>
        <source>Speed of the simulation</source>
        <translation>Vitesse de la simulation</translation>
    </message>
    <message>
        <source>Temperature of the source, as typed</source>
        <translation>Température de la source, saisie à la main</translation>
    </message>
    <message>
        <source>Simulated fault</source>
        <translation>Défaut simulé</translation>
    </message>
</context>
<context>
    <name>bask::RunStateChip</name>
    <message>
        <source>Click for the reasons and what to do.</source>
        <translation>Cliquez pour les raisons et les remèdes.</translation>
    </message>
    <message>
        <source>State of the run: %1</source>
        <translation>État de l’essai&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <comment>state of the run</comment>
        <translation>INCONNU</translation>
    </message>
</context>
<context>
    <name>bask::SafetyPanel</name>
    <message>
        <source>Safety limits</source>
        <translation>Limites de sécurité</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>%1 has limits of its own: warning %2, trip %3.</source>
        <translation>%1 a ses propres limites : avertissement %2, déclenchement %3.</translation>
    </message>
</context>
<context>
    <name>bask::SaveMaterialDialog</name>
    <message>
        <source>Save as material</source>
        <translation>Enregistrer comme matériau</translation>
    </message>
    <message>
        <source>measured on a sample, data sheet, book</source>
        <translation>mesure sur échantillon, fiche technique, livre</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Values, with their standard uncertainties</source>
        <translation>Valeurs, avec leur incertitude type</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnue</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>Incertitude type&#xa0;: %1</translation>
    </message>
    <message>
        <source>The library has a material of this name. Its values are replaced.</source>
        <translation>La bibliothèque a un matériau de ce nom. Ses valeurs sont remplacées.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>As it is, or as a share of the value: 2 %</source>
        <translation>Telle quelle, ou en part de la valeur : 2 %</translation>
    </message>
</context>
<context>
    <name>bask::SceneOverlay</name>
    <message>
        <source>x (cm)</source>
        <translation>x (cm)</translation>
    </message>
    <message>
        <source>y (cm)</source>
        <translation>y (cm)</translation>
    </message>
    <message>
        <source>z (cm)</source>
        <translation>z (cm)</translation>
    </message>
    <message>
        <source>θx (°)</source>
        <translation>θx (°)</translation>
    </message>
    <message>
        <source>θy (°)</source>
        <translation>θy (°)</translation>
    </message>
    <message>
        <source>θz (°)</source>
        <translation>θz (°)</translation>
    </message>
    <message>
        <source>object&apos;s x (cm)</source>
        <translation>x de l’objet (cm)</translation>
    </message>
    <message>
        <source>object&apos;s y (cm)</source>
        <translation>y de l’objet (cm)</translation>
    </message>
    <message>
        <source>object&apos;s z (cm)</source>
        <translation>z de l’objet (cm)</translation>
    </message>
</context>
<context>
    <name>bask::SceneView</name>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>3-D scene</source>
        <translation>Scène 3D</translation>
    </message>
    <message>
        <source>The 3-D scene needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>La scène 3D demande OpenGL 3.2, que cet affichage n’offre pas. Tout le reste fonctionne.</translation>
    </message>
</context>
<context>
    <name>bask::SerialForm</name>
    <message>
        <source>no parity</source>
        <translation>sans parité</translation>
    </message>
    <message>
        <source>even parity</source>
        <translation>parité paire</translation>
    </message>
    <message>
        <source>odd parity</source>
        <translation>parité impaire</translation>
    </message>
    <message>
        <source>Speed of the line, baud</source>
        <translation>Vitesse de la ligne, bauds</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>Bits de données</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>Parité</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>Bits d’arrêt</translation>
    </message>
</context>
<context>
    <name>bask::SessionActions</name>
    <message>
        <source>Unsaved experiment</source>
        <translation>Expérience non enregistrée</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed and not saved.</source>
        <translation>«&#xa0;%1&#xa0;» a été modifié et n’est pas enregistré.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Abandonner les modifications</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Open an experiment or a session</source>
        <translation>Ouvrir une expérience ou une session</translation>
    </message>
    <message>
        <source>Experiments and sessions (*.json *.bask);;Experiments (*.json);;Sessions (*.bask);;All files (*)</source>
        <translation>Expériences et sessions (*.json *.bask);;Expériences (*.json);;Sessions (*.bask);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Ouvrir une session</translation>
    </message>
    <message>
        <source>Sessions (*.bask);;All files (*)</source>
        <translation>Sessions (*.bask);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>Enregistrer l’expérience</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>Expériences (*.json)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Sessions (*.bask)</source>
        <translation>Sessions (*.bask)</translation>
    </message>
    <message>
        <source>Session saved as %1</source>
        <translation>Session enregistrée sous&#xa0;%1</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>Open a rig</source>
        <translation>Ouvrir un banc</translation>
    </message>
    <message>
        <source>Rigs (*.json);;All files (*)</source>
        <translation>Bancs (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save the rig</source>
        <translation>Enregistrer le banc</translation>
    </message>
    <message>
        <source>The rig was saved as %1.</source>
        <translation>Le banc a été enregistré sous %1.</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Texts (*.txt);;All files (*)</source>
        <translation>Textes (*.txt);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>Le rapport a été enregistré sous %1.</translation>
    </message>
    <message>
        <source>Folder of recorded runs</source>
        <translation>Dossier des essais enregistrés</translation>
    </message>
    <message>
        <source>Folder for the exported files</source>
        <translation>Dossier des fichiers exportés</translation>
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
        <source>&quot;%1&quot; was not opened: edits were made or recovered while it was read. Open it again to replace them.</source>
        <translation>« %1 » n’a pas été ouvert : des modifications ont été faites ou récupérées pendant sa lecture. Ouvrez-le à nouveau pour les remplacer.</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>Limites du banc réel</translation>
    </message>
    <message>
        <source>&quot;%1&quot; allows the real rig more than now:</source>
        <translation>« %1 » permet au banc réel plus que maintenant :</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>Robot, source, objets et capteurs le supportent-ils ?</translation>
    </message>
    <message>
        <source>Open with these limits</source>
        <translation>Ouvrir avec ces limites</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Enregistrer la comparaison</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>The experiment of %1 is open as a new one, which is not saved yet.</source>
        <translation>L’expérience de %1 est ouverte comme une nouvelle, qui n’est pas encore enregistrée.</translation>
    </message>
    <message>
        <source>Figures (*%1)</source>
        <translation>Figures (*%1)</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>Enregistrer le tableau</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>Enregistrer la figure</translation>
    </message>
    <message>
        <source>No table was written: the first samples of the shown time are in the recording only. Open it on the Review page and export the table there, or show a later stretch of time.</source>
        <translation>Aucun tableau n’a été écrit : les premiers échantillons du temps affiché ne sont que dans l’enregistrement. Ouvrez-le dans la page Relecture et exportez-y le tableau, ou affichez un intervalle de temps plus tardif.</translation>
    </message>
    <message>
        <source>Figures and reports are drawn only while no run and no recipe is on or begins, no heat is asked for and the robot stands still: the window, with its STOP, would have to wait for them. Nothing was written.</source>
        <translation>Les figures et les rapports ne sont tracés que si aucun essai et aucune recette n’est en cours ni ne commence, si aucune chauffe n’est demandée et si le robot est immobile : la fenêtre, avec son STOP, devrait les attendre. Rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>Choisir un autre nom</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 existe déjà.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Save the NeXus file</source>
        <translation>Enregistrer le fichier NeXus</translation>
    </message>
    <message>
        <source>NeXus (*.nxs)</source>
        <translation>NeXus (*.nxs)</translation>
    </message>
</context>
<context>
    <name>bask::SessionExport</name>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n fichier écrit dans&#xa0;%1</numerusform>
            <numerusform>%n fichiers écrits dans&#xa0;%1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>%1 écrit dans&#xa0;%2</translation>
    </message>
</context>
<context>
    <name>bask::SessionList</name>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%1 sur %n session</numerusform>
            <numerusform>%1 sur %n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n échantillon</numerusform>
            <numerusform>%n échantillons</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose the folder whose runs are listed</source>
        <translation>Choisir le dossier dont les essais sont listés</translation>
    </message>
    <message>
        <source>Close it properly</source>
        <translation>Clôturer</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Dossier…</translation>
    </message>
    <message>
        <source>Kept in the session file. A recording without an end has to be closed first.</source>
        <translation>Conservées dans le fichier de session. Un enregistrement sans fin doit d’abord être clôturé.</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>RÉEL</translation>
    </message>
    <message>
        <source>No recorded runs in this folder.</source>
        <translation>Aucun essai enregistré dans ce dossier.</translation>
    </message>
    <message>
        <source>Open on this page</source>
        <translation>Ouverte sur cette page</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>Ouvrir l’essai choisi</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Issue</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Superposer</translation>
    </message>
    <message>
        <source>Reading the folder…</source>
        <translation>Lecture du dossier…</translation>
    </message>
    <message>
        <source>Recorded runs</source>
        <translation>Essais enregistrés</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Enregistré</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>Banc</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULÉ</translation>
    </message>
    <message>
        <source>Search the recorded runs</source>
        <translation>Chercher dans les essais enregistrés</translation>
    </message>
    <message>
        <source>Tags of the selected run, with commas</source>
        <translation>Étiquettes de l’essai choisi, séparées par des virgules</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>Étiquettes</translation>
    </message>
    <message>
        <source>The recording has no end: Bask or the computer went down. Saved: %1, until %2 after Start; at most the last %3 s before it went down are missing.</source>
        <translation>L’enregistrement n’a pas de fin : Bask ou l’ordinateur s’est arrêté. Conservé : %1, jusqu’à %2 après le démarrage ; il manque au plus les %3 dernières secondes.</translation>
    </message>
    <message>
        <source>The runs listed are in %1</source>
        <translation>Les essais listés sont dans %1</translation>
    </message>
    <message>
        <source>This run is being recorded now.</source>
        <translation>Cet essai est en cours d’enregistrement.</translation>
    </message>
    <message>
        <source>with commas</source>
        <translation>séparées par des virgules</translation>
    </message>
    <message>
        <source>Search names, experiments, operators, samples, notes, tags</source>
        <translation>Chercher noms, expériences, opérateurs, échantillons, notes, étiquettes</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Opérateur</translation>
    </message>
    <message>
        <source>Sample / batch</source>
        <translation>Échantillon / lot</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>No run matches &quot;%1&quot;.</source>
        <translation>Aucun essai ne correspond à «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Show all runs</source>
        <translation>Montrer tous les essais</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Ouvrir</translation>
    </message>
    <message>
        <source>O&amp;verlay</source>
        <translation>&amp;Superposer</translation>
    </message>
    <message>
        <source>Open as &amp;new experiment</source>
        <translation>Ouvrir comme &amp;nouvelle expérience</translation>
    </message>
    <message>
        <source>&amp;Sort by</source>
        <translation>&amp;Trier par</translation>
    </message>
    <message>
        <source>Finds the runs that have every word in what the list shows, or among objects, materials and notes.</source>
        <translation>Trouve les essais qui ont chacun des mots dans ce que montre la liste, ou parmi les objets, les matériaux et les notes.</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Régulateur</translation>
    </message>
    <message>
        <source>Alarms…</source>
        <translation>Alarmes…</translation>
    </message>
    <message>
        <source>Which alarms the listed runs had, how often and when</source>
        <translation>Les alarmes qu’ont eues les essais listés, combien de fois et quand</translation>
    </message>
    <message>
        <source>From Start to Stop, STOP or the engine&apos;s end of the run. What is recorded after it, until all is away or cold, does not count.</source>
        <translation>Du démarrage à l’arrêt, à STOP ou à la fin de l’essai par le moteur. Ce qui est enregistré ensuite, jusqu’à ce que tout soit éloigné ou froid, ne compte pas.</translation>
    </message>
    <message>
        <source>Lay the selected runs over the open one</source>
        <translation>Superposer les essais choisis à celui qui est ouvert</translation>
    </message>
    <message>
        <source>Draws the selected runs over the one that is open, all from their Start. Without an open one, select several (Ctrl and click): the first of them is opened.</source>
        <translation>Dessine les essais choisis par-dessus celui qui est ouvert, tous depuis leur démarrage. Si aucun n’est ouvert, choisissez-en plusieurs (Ctrl et un clic)&#xa0;: le premier est ouvert.</translation>
    </message>
    <message>
        <source>Not verified: nobody has looked yet whether the recording is as it was made.</source>
        <translation>Non vérifié : personne n’a encore regardé si l’enregistrement est tel qu’il a été fait.</translation>
    </message>
    <message>
        <source>%1, not verified</source>
        <comment>an outcome</comment>
        <translation>%1, non vérifié</translation>
    </message>
    <message>
        <source>What each run told at its end; in italics until its recording was verified: a short one while nothing else is to be done, a long one when it is opened. Damage of its file is found when the run is selected, too. All of it is listed until the file changes or Bask is closed.</source>
        <translation>Ce que chaque essai a dit à sa fin ; en italique jusqu’à ce que son enregistrement soit vérifié : un court quand il n’y a rien d’autre à faire, un long quand il est ouvert. Un fichier endommagé est aussi reconnu quand l’essai est choisi. Tout cela reste marqué jusqu’à ce que le fichier change ou que Bask soit fermé.</translation>
    </message>
</context>
<context>
    <name>bask::SheetPanel</name>
    <message>
        <source>A marker&apos;s side is truly %1.</source>
        <translation>Le côté d’un marqueur mesure en réalité %1.</translation>
    </message>
    <message>
        <source>A square&apos;s side is truly %1.</source>
        <translation>Le côté d’une case mesure en réalité %1.</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>&amp;Dictionnaire</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>Mire d’étalonnage</translation>
    </message>
    <message>
        <source>Give the markers&apos; numbers such as 1-4, 11.</source>
        <translation>Donnez les numéros des marqueurs, par exemple 1-4, 11.</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>Marqueurs</translation>
    </message>
    <message>
        <source>Measured &amp;length</source>
        <translation>&amp;Longueur mesurée</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Numéros</translation>
    </message>
    <message>
        <source>Of the ruler on the print, which is 100 mm long.</source>
        <translation>De la règle imprimée, longue de 100 mm.</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>&amp;Papier</translation>
    </message>
    <message>
        <source>Printers scale, and no picture tells how large a square is: measure the ruler on the print, from 0 to 100 mm.</source>
        <translation>Les imprimantes changent l’échelle, et aucune image ne dit la taille d’une case : mesurez la règle imprimée, de 0 à 100 mm.</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>Enregistrer la feuille</translation>
    </message>
    <message>
        <source>Saved. Print it at 100 % (actual size) and measure its ruler.</source>
        <translation>Enregistré. Imprimez-la à 100 % (taille réelle) et mesurez sa règle.</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Feuille</translation>
    </message>
    <message>
        <source>Sheets to be printed</source>
        <translation>Feuilles à imprimer</translation>
    </message>
    <message>
        <source>&amp;Side of a marker</source>
        <translation>&amp;Côté d’un marqueur</translation>
    </message>
    <message>
        <source>Such as 1-4, 11</source>
        <translation>Par exemple 1-4, 11</translation>
    </message>
    <message>
        <source>The first of %1 pages</source>
        <translation>La première de %1 pages</translation>
    </message>
    <message>
        <source>The sheet as it is printed</source>
        <translation>La feuille telle qu’elle est imprimée</translation>
    </message>
    <message>
        <source>Use the true lengths</source>
        <translation>Utiliser les longueurs réelles</translation>
    </message>
    <message>
        <source>With its black border.</source>
        <translation>Avec son bord noir.</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Impression</translation>
    </message>
    <message>
        <source>The sheet was saved as %1.</source>
        <translation>La feuille a été enregistrée sous le nom %1.</translation>
    </message>
</context>
<context>
    <name>bask::ShelfPopup</name>
    <message>
        <source>An alarm of priority 1 is shelved for a shorter time.</source>
        <translation>Une alarme de priorité 1 se met de côté moins longtemps.</translation>
    </message>
    <message>
        <source>Put this alarm aside for a time. It comes back by itself, and the engine goes on watching and acting.</source>
        <translation>Mettre cette alarme de côté pour un temps. Elle revient d’elle-même, et le moteur continue de surveiller et d’agir.</translation>
    </message>
    <message>
        <source>Why? (needed)</source>
        <translation>Pourquoi ? (nécessaire)</translation>
    </message>
    <message>
        <source>Why the alarm is shelved</source>
        <translation>Pourquoi l’alarme est mise de côté</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>Shelve for %1 min</source>
        <translation>Mettre de côté %1 min</translation>
    </message>
</context>
<context>
    <name>bask::SourceTile</name>
    <message>
        <source>Source</source>
        <translation>Source</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Slope of the readings of the last 10 s</source>
        <translation>Pente des mesures des 10 dernières secondes</translation>
    </message>
    <message>
        <source>Where the heat goes, or the set point with which a run begins while it is off</source>
        <translation>Où va le chauffage ou, tant qu’il est coupé, la consigne avec laquelle un essai commence</translation>
    </message>
    <message>
        <source>Temperature of the source</source>
        <translation>Température de la source</translation>
    </message>
</context>
<context>
    <name>bask::SourceWords</name>
    <message>
        <source>How long it takes to heat it is not known.</source>
        <translation>On ne sait pas combien de temps il faut pour la chauffer.</translation>
    </message>
    <message>
        <source>Heated from now on it takes about %1.</source>
        <translation>Chauffée à partir de maintenant, il lui faut environ %1.</translation>
    </message>
    <message>
        <source>The source has %1, its set point is %2 (%3). Start does not wait for it: the run begins, and its time counts, while the source warms up.</source>
        <translation>La source est à %1, sa consigne est de %2 (%3). Démarrer ne l’attend pas&#xa0;: l’essai commence, et son temps compte, pendant que la source chauffe.</translation>
    </message>
    <message>
        <source>The run has ended. Its time and its recording go on until the source and the objects are cold (source %1), or until the next Arm.</source>
        <translation>L’essai est terminé. Son temps et son enregistrement continuent jusqu’à ce que la source et les objets soient froids (source %1), ou jusqu’au prochain armement.</translation>
    </message>
</context>
<context>
    <name>bask::StateBar</name>
    <message>
        <source>The engine is not answering. The robot ends its step, and a heat source with a watchdog goes off by itself. Look at the rig, then close Bask and start it again.</source>
        <translation>Le moteur ne répond pas. Le robot termine son pas, et une source de chaleur munie d’un chien de garde s’éteint d’elle-même. Regardez le banc, puis fermez Bask et relancez-le.</translation>
    </message>
    <message>
        <source>The rig is simulated: no device moves or heats.</source>
        <translation>Le banc est simulé&#xa0;: aucun appareil ne bouge ni ne chauffe.</translation>
    </message>
    <message>
        <source>The rig is real: Start moves it and opens the heat.</source>
        <translation>Le banc est réel&#xa0;: Démarrer le met en mouvement et ouvre le chauffage.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>Temps depuis le démarrage</translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation>État de l’essai</translation>
    </message>
    <message>
        <source>Click to change it.</source>
        <translation>Cliquer pour le changer.</translation>
    </message>
    <message>
        <source>Simulated faults, which Tools &gt; Simulate fault ends:</source>
        <translation>Défauts simulés, auxquels Outils &gt; Simuler un défaut met fin&#xa0;:</translation>
    </message>
    <message>
        <source>recorded until cold</source>
        <comment>under the clock: the run has ended</comment>
        <translation>enreg. jusqu’au froid</translation>
    </message>
    <message>
        <source>until cold</source>
        <comment>the same where there is less room</comment>
        <translation>jusqu’au froid</translation>
    </message>
</context>
<context>
    <name>bask::StatusLine</name>
    <message>
        <source>engine not answering</source>
        <translation>le moteur ne répond pas</translation>
    </message>
    <message>
        <source>readings %1 s old</source>
        <translation>mesures âgées de&#xa0;%1 s</translation>
    </message>
    <message>
        <source>no readings</source>
        <translation>aucune mesure</translation>
    </message>
    <message>
        <source>(simulation ×%1)</source>
        <translation>(simulation ×%1)</translation>
    </message>
    <message>
        <source>loop %1 Hz, late %2</source>
        <translation>boucle&#xa0;%1 Hz, retards&#xa0;%2</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>pas d’enregistrement</translation>
    </message>
    <message>
        <source>recording %1, %2 samples</source>
        <translation>enregistre&#xa0;%1,&#xa0;%2 échantillons</translation>
    </message>
    <message>
        <source>Control steps a second, and how many began late</source>
        <translation>Pas de commande par seconde, et combien ont commencé en retard</translation>
    </message>
    <message>
        <source>Temperature unit</source>
        <translation>Unité de température</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>source not seen</source>
        <translation>source non vue</translation>
    </message>
    <message>
        <source>source not seen for %1 s, predicted</source>
        <translation>source non vue depuis %1 s, prédite</translation>
    </message>
    <message>
        <source>source followed</source>
        <translation>source suivie</translation>
    </message>
    <message>
        <source>%1 ms late</source>
        <translation>%1 ms de retard</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>How the camera follows the source: time from the light to the pose, two standard deviations of its place</source>
        <translation>Comment la caméra suit la source : temps de la lumière à la pose, deux écarts types de sa place</translation>
    </message>
    <message>
        <source>Age of the newest temperature readings; of a real rig, of each device&apos;s newest answer</source>
        <translation>Âge des dernières mesures de température ; pour un banc réel, de la dernière réponse de chaque appareil</translation>
    </message>
    <message>
        <source>source %1,</source>
        <translation>source %1,</translation>
    </message>
    <message>
        <source>source %1 as typed,</source>
        <translation>source %1 selon la saisie,</translation>
    </message>
    <message>
        <source>source: no temperature typed,</source>
        <translation>source : aucune température saisie,</translation>
    </message>
    <message>
        <source>monitoring fails</source>
        <translation>surveillance en échec</translation>
    </message>
    <message>
        <source>monitored</source>
        <translation>surveillé</translation>
    </message>
    <message numerus="yes">
        <source>What the run does is published (View &gt; Monitoring): %n message(s)</source>
        <translation>
            <numerusform>Ce que fait l’essai est publié (Affichage &gt; Surveillance)&#xa0;: %n message</numerusform>
            <numerusform>Ce que fait l’essai est publié (Affichage &gt; Surveillance)&#xa0;: %n messages</numerusform>
        </translation>
    </message>
    <message>
        <source>monitoring begins</source>
        <translation>surveillance&#xa0;: début</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s) were not published</source>
        <translation>
            <numerusform>%n événement n’a pas été publié</numerusform>
            <numerusform>%n événements n’ont pas été publiés</numerusform>
        </translation>
    </message>
    <message>
        <source>Newest temperature of the source, and whether it is heated, as the device has confirmed. UNKNOWN: it may be hot, whatever was ordered. Heats though off: it warms all the same.</source>
        <translation>Dernière température de la source, et si elle est chauffée, comme l’appareil l’a confirmé. INCONNU : elle peut être chaude, quel que soit l’ordre donné. Chauffe quoique coupée : elle se réchauffe malgré tout.</translation>
    </message>
    <message>
        <source>recorded until cold: source %1; %2, %3 samples</source>
        <translation>enregistré jusqu’au froid : source %1 ; %2, %3 échantillons</translation>
    </message>
</context>
<context>
    <name>bask::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Zero velocity and heater off now; latched until reset (F12).
This is a software stop, not a safety-rated emergency stop.</source>
        <translation>Vitesse nulle et chauffage coupé immédiatement&#xa0;; verrouillé jusqu’à réinitialisation (F12).
C’est un arrêt logiciel, et non un arrêt d’urgence de sécurité.</translation>
    </message>
    <message>
        <source>STOP: zero velocity and heater off now (F12)</source>
        <translation>STOP&#xa0;: vitesse nulle et chauffage coupé immédiatement (F12)</translation>
    </message>
    <message>
        <source>Software stop, not a safety-rated emergency stop.</source>
        <translation>Arrêt logiciel, et non arrêt d’urgence de sécurité.</translation>
    </message>
</context>
<context>
    <name>bask::SurfacesView</name>
    <message>
        <source>The animation is not whole: the experiment was changed while it was saved.</source>
        <translation>L’animation n’est pas complète : l’expérience a été modifiée pendant l’enregistrement.</translation>
    </message>
    <message>
        <source>3-D scene: where the end-effector may be for each object to hold its target</source>
        <translation>Scène 3D : où l’effecteur peut être pour que chaque objet tienne sa consigne</translation>
    </message>
    <message>
        <source>End-effector positions</source>
        <translation>Positions de l’effecteur</translation>
    </message>
    <message>
        <source>Each object&apos;s own positions (as in the paper)</source>
        <translation>Positions de chaque objet (comme dans l’article)</translation>
    </message>
    <message>
        <source>End-effector angles</source>
        <translation>Angles de l’effecteur</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over</source>
        <translation>Ce sur quoi les surfaces sont tracées</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over. On its surface an object holds its target.</source>
        <translation>Ce sur quoi les surfaces sont tracées. Sur sa surface, un objet tient sa consigne.</translation>
    </message>
    <message>
        <source>Picture saved: %1</source>
        <translation>Image enregistrée : %1</translation>
    </message>
    <message>
        <source>Animation saved in %1: frame-1.png to frame-9.png, and all in panels.png</source>
        <translation>Animation enregistrée dans %1 : frame-1.png à frame-9.png, et toutes dans panels.png</translation>
    </message>
</context>
<context>
    <name>bask::SurveyBar</name>
    <message>
        <source>The robot moves to pose %1 of %2.</source>
        <translation>Le robot va à la pose %1 sur %2.</translation>
    </message>
    <message>
        <source>Looking, picture %1 of %2. Nothing may move.</source>
        <translation>Observation, image %1 sur %2. Rien ne doit bouger.</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Calcul…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Pictures looked at</source>
        <translation>Images observées</translation>
    </message>
</context>
<context>
    <name>bask::TargetScene</name>
    <message>
        <source>Picked</source>
        <translation>Choisi</translation>
    </message>
    <message>
        <source>All targets</source>
        <translation>Toutes les consignes</translation>
    </message>
    <message>
        <source>Closest</source>
        <translation>Au plus près</translation>
    </message>
    <message>
        <source>%1 %2 to %3°</source>
        <comment>an angle, its least and largest value</comment>
        <translation>%1 de %2 à %3°</translation>
    </message>
    <message>
        <source>The robot does not turn</source>
        <translation>Le robot ne tourne pas</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>Robot : %1</translation>
    </message>
    <message>
        <source>%1 %2: nowhere here</source>
        <comment>object, target</comment>
        <translation>%1 %2 : nulle part ici</translation>
    </message>
    <message>
        <source>3-D scene of the targets</source>
        <translation>Scène 3D des consignes</translation>
    </message>
    <message>
        <source>The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>La scène 3D des consignes demande OpenGL 3.2, que cet affichage n’offre pas. Tout le reste fonctionne.</translation>
    </message>
    <message>
        <source>%1: F %2, steady %3, %4/%5</source>
        <comment>name, view factor, temperature, slope</comment>
        <translation>%1 : F %2, équilibre %3, %4/%5</translation>
    </message>
</context>
<context>
    <name>bask::TargetsPage</name>
    <message>
        <source>Target of %1</source>
        <translation>Consigne de&#xa0;%1</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Nearest reachable</source>
        <translation>La plus proche</translation>
    </message>
    <message>
        <source>Set the target of %1 to the nearest reachable one</source>
        <translation>Régler la consigne de&#xa0;%1 sur la plus proche atteignable</translation>
    </message>
    <message>
        <source>Set the target to %1</source>
        <translation>Régler la consigne sur&#xa0;%1</translation>
    </message>
    <message>
        <source>The target is within reach already.</source>
        <translation>La consigne est déjà atteignable.</translation>
    </message>
    <message>
        <source>There is no object yet. Add one on the Objects page.</source>
        <translation>Il n’y a pas encore d’objet. Ajoutez-en un sur la page Objets.</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>, </translation>
    </message>
    <message>
        <source>Checking the targets…</source>
        <translation>Vérification des consignes…</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Consignes</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Consigne</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdict</translation>
    </message>
    <message>
        <source>What is checked</source>
        <translation>Ce qui est vérifié</translation>
    </message>
    <message>
        <source>To stay at its target an object must take up as much heat as it gives off. That fixes its view factor F, the share of its sight that the source fills: near 0 far away, near 1 close to the source and facing it. A target is reachable if its F occurs somewhere in the robot&apos;s workspace with the clearance kept; all can be held together if one pose has the F of each. In the bars, solid is what can be held here, outlined what the source could hold at F = 1.</source>
        <translation>Pour rester à sa consigne, un objet doit recevoir autant de chaleur qu’il en cède. Cela fixe son facteur de forme F, la part de son champ de vue que la source remplit&#xa0;: proche de 0 au loin, proche de 1 tout près et face à elle. Une consigne est atteignable si son F existe quelque part dans l’espace de travail du robot, la garde étant respectée ; toutes peuvent être tenues ensemble si une pose offre à chaque objet son F. Dans les barres, le plein est ce qui peut être tenu ici, le contour ce que la source pourrait tenir à F = 1.</translation>
    </message>
    <message>
        <source>Starting out of reach</source>
        <translation>Démarrer hors d’atteinte</translation>
    </message>
    <message>
        <source>All targets can be held together.</source>
        <translation>Toutes les consignes peuvent être tenues ensemble.</translation>
    </message>
    <message>
        <source>Best compromise, at %1: %2.</source>
        <translation>Meilleur compromis, en %1 : %2.</translation>
    </message>
    <message>
        <source>Cannot be held: %1.</source>
        <translation>Ne peuvent être tenues : %1.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Keep the target of %1</source>
        <translation>Garder la consigne de %1</translation>
    </message>
    <message>
        <source>Leave this target as it is when the nearest ones are sought.</source>
        <translation>Laisser cette consigne telle quelle quand on cherche les plus proches.</translation>
    </message>
    <message>
        <source>Nearest targets that can be held: %1.</source>
        <translation>Consignes les plus proches qui peuvent être tenues : %1.</translation>
    </message>
    <message>
        <source>The target can be held.</source>
        <translation>La consigne peut être tenue.</translation>
    </message>
    <message>
        <source>Those to be kept cannot be held together.</source>
        <translation>Celles à garder ne peuvent être tenues ensemble.</translation>
    </message>
    <message>
        <source>Use nearest feasible</source>
        <translation>Prendre les plus proches</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Surfaces</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Predicting how long a run takes…</source>
        <translation>Prévision de la durée d&apos;un essai…</translation>
    </message>
    <message>
        <source>Reachable alone</source>
        <translation>Atteignable seule</translation>
    </message>
    <message>
        <source>The targets to be kept cannot be held together: untick “Keep” for one.</source>
        <translation>Les consignes à garder ne peuvent être tenues ensemble : décochez « Garder » pour l’une d’elles.</translation>
    </message>
    <message>
        <source>A run with a target out of reach needs your explicit agreement at Start. It holds the best compromise it finds, says so, and the session records that you agreed. During a run new targets are taken at once; if they cannot be held, an event says why.</source>
        <translation>Un essai avec une consigne hors d’atteinte demande votre accord explicite au démarrage. Il tient le meilleur compromis qu’il trouve, le dit, et l’enregistrement garde trace de votre accord. Pendant un essai, de nouvelles consignes sont prises aussitôt ; si elles ne peuvent être tenues, un événement dit pourquoi.</translation>
    </message>
    <message>
        <source>No object shades another at this pose.</source>
        <translation>À cette pose, aucun objet ne fait d’ombre à un autre.</translation>
    </message>
    <message>
        <source>Held at %1; %2 from the nearest limit: %3.</source>
        <translation>Maintien en %1 ; à %2 de la limite la plus proche : %3.</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose does not settle within %1 (simulated).</source>
        <translation>Prévision : partant de la pose de départ, un essai ne se stabilise pas en moins de %1 (simulé).</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose has settled after %1 (simulated).</source>
        <translation>Prévision : partant de la pose de départ, un essai est stabilisé au bout de %1 (simulé).</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCameraForm</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>Prendre un profil dans un fichier</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>Profils (*.json)</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Caméra</translation>
    </message>
    <message>
        <source>Kind of thermal camera</source>
        <translation>Modèle de caméra thermique</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>Take what the camera&apos;s numbers mean from a file</source>
        <translation>Prendre dans un fichier ce que signifient les nombres de la caméra</translation>
    </message>
    <message>
        <source>Its pose in the robot&apos;s base is known</source>
        <translation>Sa pose dans la base du robot est connue</translation>
    </message>
    <message>
        <source>The camera&apos;s axes: x right, y down, z along its view. Without its pose it shows pictures and reads no object.</source>
        <translation>Axes de la caméra&#xa0;: x à droite, y en bas, z dans le sens de la visée. Sans sa pose, elle montre des images et ne lit aucun objet.</translation>
    </message>
    <message>
        <source>Pose of the camera, %1</source>
        <translation>Pose de la caméra, %1</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCanvas</name>
    <message>
        <source>no value</source>
        <translation>sans valeur</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturé</translation>
    </message>
    <message>
        <source>below range</source>
        <translation>sous la plage</translation>
    </message>
    <message>
        <source>%1 at column %2, row %3</source>
        <translation>%1, colonne %2, ligne %3</translation>
    </message>
    <message>
        <source>saturated %1</source>
        <comment>a number of pixels</comment>
        <translation>saturés %1</translation>
    </message>
    <message>
        <source>below range %1</source>
        <comment>a number of pixels</comment>
        <translation>sous la plage %1</translation>
    </message>
    <message>
        <source>no value %1</source>
        <comment>a number of pixels</comment>
        <translation>sans valeur %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>Image thermique</translation>
    </message>
    <message>
        <source>Arrow keys place a spot, which tells a pixel&apos;s temperature; Escape removes it.</source>
        <translation>Les flèches placent un point de mesure, qui dit la température d’un pixel&#xa0;; Échap l’enlève.</translation>
    </message>
    <message>
        <source>Apparent temperature: that of a black body which looks the same. The objects&apos; temperatures have reflections and emittance taken into account.</source>
        <translation>Température apparente&#xa0;: celle d’un corps noir de même aspect. Les températures des objets tiennent compte des réflexions et de l’émissivité.</translation>
    </message>
</context>
<context>
    <name>bask::ThermalControls</name>
    <message>
        <source>Inferno</source>
        <translation>Inferno</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Gris</translation>
    </message>
    <message>
        <source>Colours of the thermal picture</source>
        <translation>Couleurs de l’image thermique</translation>
    </message>
    <message>
        <source>Limits: objects</source>
        <translation>Limites&#xa0;: objets</translation>
    </message>
    <message>
        <source>Limits: picture</source>
        <translation>Limites&#xa0;: image</translation>
    </message>
    <message>
        <source>Limits: fixed</source>
        <translation>Limites&#xa0;: fixes</translation>
    </message>
    <message>
        <source>Limits of the colours</source>
        <translation>Limites des couleurs</translation>
    </message>
    <message>
        <source>What the colours span: the objects&apos; pixels with a margin, all pixels but the 0.5 % at either end, or limits of your own.</source>
        <translation>Ce que couvrent les couleurs&#xa0;: les pixels des objets avec une marge, tous les pixels sauf 0,5&#xa0;% à chaque bout, ou vos propres limites.</translation>
    </message>
    <message>
        <source>Lower limit of the colours</source>
        <translation>Limite basse des couleurs</translation>
    </message>
    <message>
        <source>Upper limit of the colours</source>
        <translation>Limite haute des couleurs</translation>
    </message>
    <message>
        <source>No isotherm</source>
        <translation>Sans isotherme</translation>
    </message>
    <message>
        <source>Isotherm: above</source>
        <translation>Isotherme&#xa0;: au-dessus</translation>
    </message>
    <message>
        <source>Isotherm: near</source>
        <translation>Isotherme&#xa0;: autour</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>Isotherme</translation>
    </message>
    <message>
        <source>Draws the pixels in green that are above a temperature, or nearer to it than 0.5 K.</source>
        <translation>Dessine en vert les pixels au-dessus d’une température, ou à moins de 0,5&#xa0;K d’elle.</translation>
    </message>
    <message>
        <source>Temperature of the isotherm</source>
        <translation>Température de l’isotherme</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Show the objects with a margin instead of the whole picture.</source>
        <translation>Montrer les objets avec une marge au lieu de toute l’image.</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Smooth the picture; else each pixel is a square of one colour.</source>
        <translation>Lisser l’image&#xa0;; sinon chaque pixel est un carré d’une couleur.</translation>
    </message>
</context>
<context>
    <name>bask::ThermalHistogramPlot</name>
    <message numerus="yes">
        <source>%1: %n pixel(s)</source>
        <translation>
            <numerusform>%1&#xa0;: %n pixel</numerusform>
            <numerusform>%1&#xa0;: %n pixels</numerusform>
        </translation>
    </message>
    <message>
        <source>No pixels are read</source>
        <translation>Aucun pixel n’est lu</translation>
    </message>
    <message>
        <source>mean %1, s.d. %2</source>
        <comment>standard deviation</comment>
        <translation>moyenne %1, écart-type %2</translation>
    </message>
    <message>
        <source>Distribution of apparent temperatures</source>
        <translation>Répartition des températures apparentes</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>moyenne %1</translation>
    </message>
</context>
<context>
    <name>bask::ThermalObjectList</name>
    <message>
        <source>Temperatures by the thermal camera</source>
        <translation>Températures par la caméra thermique</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Étendue</translation>
    </message>
    <message>
        <source>Reflections and emittance are taken into account; with two standard deviations.</source>
        <translation>Les réflexions et l’émissivité sont prises en compte&#xa0;; avec deux écarts-types.</translation>
    </message>
    <message>
        <source>Largest difference across the object.</source>
        <translation>Plus grande différence sur l’objet.</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Toute l’image</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>Apparent temperatures of all but the 0.5 % at either end.</source>
        <translation>Températures apparentes de tous les pixels sauf 0,5&#xa0;% à chaque bout.</translation>
    </message>
    <message>
        <source>%1 (part)</source>
        <translation>%1 (partie)</translation>
    </message>
    <message>
        <source>A part of the object is outside of the picture: the reading is that of the rest.</source>
        <translation>Une partie de l’objet est hors de l’image : la mesure est celle du reste.</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPanel</name>
    <message>
        <source>Not measured</source>
        <translation>Non mesurée</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Telle que saisie</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>Utilisée</translation>
    </message>
    <message>
        <source>The camera is at %1.</source>
        <translation>La caméra est à %1.</translation>
    </message>
    <message>
        <source>The camera is at %1, measured %2.</source>
        <translation>La caméra est à %1, mesurée %2.</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>C’est à %1 et %2 de la place que lui donne l’expérience.</translation>
    </message>
    <message>
        <source>Of the outlines %1 % were found, %2 px from where they should be.</source>
        <translation>%1 % des contours ont été trouvés, à %2 px de leur place.</translation>
    </message>
    <message>
        <source>Say on the Rig page where the thermal camera is, to 5 cm and 5 degrees.</source>
        <translation>Dites sur la page Banc où est la caméra thermique, à 5 cm et 5 degrés près.</translation>
    </message>
    <message>
        <source>No picture from the thermal camera.</source>
        <translation>Aucune image de la caméra thermique.</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>Un essai est armé ou en cours, ou un arrêt n’est pas réinitialisé. Mesurez après.</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Place</translation>
    </message>
    <message>
        <source>Where the thermal camera is</source>
        <translation>Où est la caméra thermique</translation>
    </message>
    <message>
        <source>By the outlines of the objects at several poses of the robot. The camera has to see them, and they have to be 5 K or more warmer or colder than what is behind them.</source>
        <translation>Par les contours des objets à plusieurs poses du robot. La caméra doit les voir, et ils doivent être plus chauds ou plus froids d’au moins 5 K que ce qui est derrière eux.</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>Plu&amp;sieurs poses</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>Le robot va à quelques poses de son espace de travail, jamais plus près de la source, et revient. Tenez-vous à l’écart.</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>Utiliser cette p&amp;lace</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>Telle que simulée</translation>
    </message>
    <message>
        <source>A calibration board is looked for. Stop looking first.</source>
        <translation>Une mire d’étalonnage est recherchée. Arrêtez d’abord la recherche.</translation>
    </message>
    <message>
        <source>Measured by an earlier version: measure it again</source>
        <translation>Mesurée par une version antérieure : mesurez-la à nouveau</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPictureView</name>
    <message>
        <source>The thermal camera has not given a picture yet.</source>
        <translation>La caméra thermique n’a pas encore donné d’image.</translation>
    </message>
    <message>
        <source>This picture is %1.</source>
        <translation>Image reçue %1.</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 images/s</translation>
    </message>
    <message>
        <source>shutter %1 ago, drift ± %2</source>
        <translation>obturateur il y a %1, dérive ± %2</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>âge %1 s</translation>
    </message>
    <message>
        <source>No picture was recorded.</source>
        <translation>Aucune image n’a été enregistrée.</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <translation>prise à %1</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) left out</source>
        <translation>
            <numerusform>%n image laissée de côté</numerusform>
            <numerusform>%n images laissées de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out last: %1</source>
        <translation>Laissée de côté en dernier : %1</translation>
    </message>
</context>
<context>
    <name>bask::TracePlot</name>
    <message>
        <source>translation</source>
        <translation>translation</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>%1 cm/s</source>
        <translation>%1 cm/s</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>Temps depuis le démarrage (h:min:s)</translation>
    </message>
    <message>
        <source>Time since start (min:s)</source>
        <translation>Temps depuis le démarrage (min:s)</translation>
    </message>
    <message>
        <source>Speed (% of limit)</source>
        <translation>Vitesse (% de la limite)</translation>
    </message>
    <message>
        <source>Plot against time: %1</source>
        <translation>Courbe temporelle&#xa0;:&#xa0;%1</translation>
    </message>
    <message>
        <source>Arrow keys move, plus and minus zoom, Home shows the whole run, End goes back to live.</source>
        <translation>Les flèches déplacent, plus et moins zooment, Origine montre tout l’essai, Fin revient au direct.</translation>
    </message>
    <message>
        <source>No samples yet. Traces begin with Start.</source>
        <translation>Pas encore d’échantillon. Les courbes commencent au démarrage.</translation>
    </message>
    <message>
        <source>This controller does not estimate λ₁.</source>
        <translation>Ce régulateur n’estime pas λ₁.</translation>
    </message>
    <message>
        <source>Nothing has shaded an object.</source>
        <translation>Rien n’a fait d’ombre à un objet.</translation>
    </message>
    <message>
        <source>Time since Start (h)</source>
        <translation>Temps depuis le démarrage (h)</translation>
    </message>
    <message>
        <source>Time since Start (min)</source>
        <translation>Temps depuis le démarrage (min)</translation>
    </message>
    <message>
        <source>Time since Start (s)</source>
        <translation>Temps depuis le démarrage (s)</translation>
    </message>
    <message>
        <source>Command speed</source>
        <translation>Vitesse commandée</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>quantity and unit</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Dotted: predicted. Traces begin with Start.</source>
        <translation>En pointillé&#xa0;: la prédiction. Les courbes commencent au démarrage.</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>prédit</translation>
    </message>
    <message>
        <source>predicted, not settled by then</source>
        <translation>prédit, pas encore stabilisé</translation>
    </message>
    <message>
        <source>predicted, not computed further</source>
        <translation>prédit, non calculé au-delà</translation>
    </message>
    <message>
        <source>predicted to end in a fault</source>
        <translation>prédit : finit par un défaut</translation>
    </message>
    <message>
        <source>target</source>
        <translation>consigne</translation>
    </message>
    <message>
        <source>band of ±%1</source>
        <comment>%1 is 0.5 K</comment>
        <translation>bande de ±%1</translation>
    </message>
    <message numerus="yes">
        <source>%n more without a number</source>
        <comment>moments that are close to another one</comment>
        <translation>
            <numerusform>%n autre sans numéro</numerusform>
            <numerusform>%n autres sans numéro</numerusform>
        </translation>
    </message>
    <message>
        <source>predicted; band: other sensor noise only</source>
        <translation>prédit ; bande : autre bruit des capteurs seulement</translation>
    </message>
</context>
<context>
    <name>bask::TrafficModel</name>
    <message>
        <source>sent</source>
        <translation>envoyé</translation>
    </message>
    <message>
        <source>sent by hand</source>
        <translation>envoyé à la main</translation>
    </message>
    <message>
        <source>received</source>
        <translation>reçu</translation>
    </message>
    <message>
        <source>error output</source>
        <translation>sortie d’erreur</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>fermé</translation>
    </message>
    <message numerus="yes">
        <source>%1… (%n bytes)</source>
        <translation>
            <numerusform>%1… (%n octet)</numerusform>
            <numerusform>%1… (%n octets)</numerusform>
        </translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Heure</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Octets</translation>
    </message>
</context>
<context>
    <name>bask::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Position and length of the run</source>
        <translation>Position et durée de l’essai</translation>
    </message>
    <message>
        <source>Position in the run</source>
        <translation>Position dans l’essai</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>REJEU</translation>
    </message>
    <message>
        <source>Space, while nothing else on the page takes it</source>
        <translation>Espace, tant que rien d’autre sur la page ne la prend</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Vitesse du rejeu</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>What is shown here was recorded: nothing moves or heats by it.</source>
        <translation>Ce qui est affiché ici a été enregistré : rien ne bouge ni ne chauffe.</translation>
    </message>
</context>
<context>
    <name>bask::UndoActions</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;Undo&quot; or &quot;Redo&quot;, %2 what: &quot;Undo: move of bunny&quot;</extracomment>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>A run is armed or on. This can be changed once it has stopped.</source>
        <translation>Un essai est armé ou en cours. Ceci pourra être modifié une fois l’essai arrêté.</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>Rien à rétablir</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>Rien à annuler</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>Élever une limite du banc réel</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>Élever la limite</translation>
    </message>
    <message>
        <source>This allows the rig more than now. Do robot, source, objects and sensors bear it?</source>
        <translation>Le banc pourra aller plus loin que maintenant. Robot, source, objets et capteurs le supportent-ils&#xa0;?</translation>
    </message>
</context>
<context>
    <name>bask::UnitFinder</name>
    <message>
        <source>Unit %1: %2 (%3)</source>
        <translation>Unité %1&#xa0;: %2 (%3)</translation>
    </message>
    <message>
        <source>Unit %1 answers, but no profile of this role fits</source>
        <translation>L’unité %1 répond, mais aucun profil de ce rôle ne convient</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Find devices</source>
        <translation>Chercher les appareils</translation>
    </message>
    <message>
        <source>Asks units 1 to 16 at this port. Nothing is written.</source>
        <translation>Interroge les unités 1 à 16 à ce port. Rien n’est écrit.</translation>
    </message>
    <message>
        <source>%1 %, unit %2, %3</source>
        <translation>%1 %, unité %2, %3</translation>
    </message>
    <message>
        <source>No unit from 1 to 16 answers.</source>
        <translation>Aucune unité de 1 à 16 ne répond.</translation>
    </message>
    <message>
        <source>Choose one:</source>
        <translation>Choisissez-en un&#xa0;:</translation>
    </message>
    <message>
        <source>Devices found at this port</source>
        <translation>Appareils trouvés à ce port</translation>
    </message>
</context>
<context>
    <name>bask::VerdictBox</name>
    <message>
        <source>%1, in use</source>
        <translation>%1, utilisé</translation>
    </message>
</context>
<context>
    <name>bask::VerdictText</name>
    <message>
        <source>Too hot</source>
        <translation>Trop chaud</translation>
    </message>
    <message>
        <source>Too cold</source>
        <translation>Trop froid</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>Atteignable</translation>
    </message>
    <message>
        <source>needs F = %1, at most %2 here; at most %3</source>
        <translation>demande F =&#xa0;%1, au plus&#xa0;%2 ici&#xa0;; au plus&#xa0;%3</translation>
    </message>
    <message>
        <source>below the room&apos;s %1</source>
        <translation>sous les&#xa0;%1 de l’ambiante</translation>
    </message>
    <message>
        <source>below the %1 it settles at far from the source</source>
        <translation>sous les&#xa0;%1 où il se stabilise loin de la source</translation>
    </message>
    <message>
        <source>needs F = %1, at least %2 here; at least %3</source>
        <translation>demande F =&#xa0;%1, au moins&#xa0;%2 ici&#xa0;; au moins&#xa0;%3</translation>
    </message>
    <message>
        <source>needs F = %1, up to %2 here</source>
        <translation>demande F =&#xa0;%1, jusqu’à&#xa0;%2 ici</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>dégagement</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>espace de travail %1</translation>
    </message>
</context>
<context>
    <name>bask::Verification</name>
    <message>
        <source>table %1</source>
        <translation>table %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>a time since Start</comment>
        <translation>à %1</translation>
    </message>
    <message>
        <source>Altered: in tags, or in bytes of the file that are in no row. An older Bask that changed the tags does that, too.</source>
        <translation>Modifié&#xa0;: dans les étiquettes, ou dans des octets du fichier qui ne sont dans aucune ligne. Un Bask plus ancien qui a changé les étiquettes le fait aussi.</translation>
    </message>
    <message>
        <source>Altered: %1; see bask verify</source>
        <translation>Modifié&#xa0;: %1&#xa0;; voir bask verify</translation>
    </message>
    <message>
        <source>Altered: %1, and %2 more; see bask verify</source>
        <translation>Modifié&#xa0;: %1, et %2 autres&#xa0;; voir bask verify</translation>
    </message>
    <message>
        <source>Damaged: bask verify tells what of it can be read</source>
        <translation>Endommagé&#xa0;: bask verify dit ce qui peut en être lu</translation>
    </message>
    <message>
        <source>Not verifiable: recorded by an older Bask, without a hash chain</source>
        <translation>Non vérifiable&#xa0;: enregistré par un Bask plus ancien, sans chaîne de hachage</translation>
    </message>
    <message>
        <source>Intact: %1 rows, sealed, head %2</source>
        <translation>Intact&#xa0;: %1 lignes, scellé, tête %2</translation>
    </message>
    <message>
        <source>Intact: %1 rows, not sealed, head %2</source>
        <translation>Intact&#xa0;: %1 lignes, non scellé, tête %2</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>clé %1</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>vue %1</translation>
    </message>
    <message>
        <source>index %1</source>
        <comment>of a database</comment>
        <translation>index %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <comment>of a database</comment>
        <translation>déclencheur %1</translation>
    </message>
    <message>
        <source>the file&apos;s header</source>
        <translation>l’en-tête du fichier</translation>
    </message>
    <message>
        <source>after %1</source>
        <comment>a time since Start</comment>
        <translation>après %1</translation>
    </message>
    <message>
        <source>Altered: its seal was removed. Tags, and bytes of the file that are in no row, may have been changed.</source>
        <translation>Modifié&#xa0;: son sceau a été enlevé. Les étiquettes, et des octets du fichier qui ne sont dans aucune ligne, ont pu être changés.</translation>
    </message>
</context>
<context>
    <name>bask::ViewBar</name>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>Vue : %1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Image…</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>&amp;Animation…</translation>
    </message>
</context>
<context>
    <name>bask::ViewList</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1, stands out</source>
        <translation>%1, se distingue</translation>
    </message>
    <message>
        <source>A view that is not ticked is left out.</source>
        <translation>Une vue non cochée est écartée.</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Résidu</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Views of the calibration</source>
        <translation>Vues de l’étalonnage</translation>
    </message>
</context>
<context>
    <name>bask::WholeNumberField</name>
    <message>
        <source>“%1” is not a whole number; the value stays as it was</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre entier&#xa0;; la valeur reste telle qu’elle était</translation>
    </message>
</context>
<context>
    <name>bask::WhyNot</name>
    <message>
        <source>Arm is not possible: no experiment is loaded. Open one first.</source>
        <translation>Armer est impossible : aucune expérience n’est chargée. Ouvrez-en une d’abord.</translation>
    </message>
    <message>
        <source>The rig is armed already. Press Start.</source>
        <translation>Le banc est déjà armé. Pressez Démarrer.</translation>
    </message>
    <message>
        <source>Arm is not possible: a stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>Armer est impossible : un arrêt ou un défaut est verrouillé. Supprimez sa cause, puis pressez Réinitialiser.</translation>
    </message>
    <message>
        <source>Arm is not possible yet: the run is stopping.</source>
        <translation>Armer est encore impossible : l’essai s’arrête.</translation>
    </message>
    <message>
        <source>Arm is not possible: the rig is not ready.</source>
        <translation>Armer est impossible : le banc n’est pas prêt.</translation>
    </message>
    <message>
        <source>Arm is not possible: a run is on. Stop it first.</source>
        <translation>Armer est impossible : un essai est en cours. Arrêtez-le d’abord.</translation>
    </message>
    <message>
        <source>Start is not possible: a stop or a fault is latched. Press Reset, then Arm.</source>
        <translation>Démarrer est impossible : un arrêt ou un défaut est verrouillé. Pressez Réinitialiser, puis Armer.</translation>
    </message>
    <message>
        <source>Start is not possible: a run is on.</source>
        <translation>Démarrer est impossible : un essai est en cours.</translation>
    </message>
    <message>
        <source>Start is not possible: the rig is not armed. Press Arm first.</source>
        <translation>Démarrer est impossible : le banc n’est pas armé. Pressez d’abord Armer.</translation>
    </message>
    <message>
        <source>The run is held already. Resume goes on, Stop ends it.</source>
        <translation>L’essai est déjà en pause. Reprendre le continue, Arrêter le termine.</translation>
    </message>
    <message>
        <source>Hold is not possible: the run is stopping. STOP ends all motion.</source>
        <translation>Pause est impossible : l’essai s’arrête. STOP met fin à tout mouvement.</translation>
    </message>
    <message>
        <source>There is nothing to hold: the robot does not move.</source>
        <translation>Il n’y a rien à mettre en pause : le robot ne bouge pas.</translation>
    </message>
    <message>
        <source>The run is stopping already.</source>
        <translation>L’essai s’arrête déjà.</translation>
    </message>
    <message>
        <source>There is no run to stop: a stop or a fault has ended it.</source>
        <translation>Il n’y a pas d’essai à arrêter : un arrêt ou un défaut y a mis fin.</translation>
    </message>
    <message>
        <source>There is no run to stop.</source>
        <translation>Il n’y a pas d’essai à arrêter.</translation>
    </message>
    <message>
        <source>The robot is retreating already.</source>
        <translation>Le robot se retire déjà.</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot does not answer. Take the objects away by hand, mind the heat.</source>
        <translation>Retrait impossible : le robot ne répond pas. Éloignez les objets à la main, gare à la chaleur.</translation>
    </message>
    <message>
        <source>Retreat is not possible:</source>
        <translation>Retrait impossible :</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot is not sure of its place. Look where it is, then home it or clear its alarm on the Rig page.</source>
        <translation>Retrait impossible : le robot n’est pas sûr de sa position. Voyez où il est, puis faites sa prise d’origine ou effacez son alarme à la page Banc.</translation>
    </message>
    <message>
        <source>Retreat is not possible now: there is no robot that can move, or the objects are away already.</source>
        <translation>Retrait impossible maintenant : aucun robot ne peut bouger, ou les objets sont déjà éloignés.</translation>
    </message>
    <message>
        <source>There is nothing to resume: no run is held.</source>
        <translation>Il n’y a rien à reprendre : aucun essai n’est en pause.</translation>
    </message>
    <message>
        <source>There is nothing to reset: no stop and no fault is latched.</source>
        <translation>Il n’y a rien à réinitialiser : ni arrêt ni défaut n’est verrouillé.</translation>
    </message>
    <message>
        <source>A run is armed or on. Stop it first; then another experiment can be begun.</source>
        <translation>Un essai est armé ou en cours. Arrêtez-le d’abord&#xa0;; une autre expérience pourra alors être commencée.</translation>
    </message>
    <message>
        <source>There is no recording to end.</source>
        <translation>Il n’y a pas d’enregistrement à clore.</translation>
    </message>
    <message>
        <source>The recording is that of the run, which is armed or on. It ends with the run.</source>
        <translation>L’enregistrement est celui de l’essai, qui est armé ou en cours. Il se termine avec lui.</translation>
    </message>
    <message>
        <source>There is no alarm to acknowledge.</source>
        <translation>Il n’y a pas d’alarme à acquitter.</translation>
    </message>
    <message>
        <source>All alarms are acknowledged already.</source>
        <translation>Toutes les alarmes sont déjà acquittées.</translation>
    </message>
    <message>
        <source>There is no recording to save yet. Arm begins one.</source>
        <translation>Il n’y a pas encore d’enregistrement à garder. Armer en commence un.</translation>
    </message>
    <message>
        <source>This run has no prediction: it was not finished at Start.</source>
        <translation>Cet essai n’est pas prédit : le calcul n’était pas fini au démarrage.</translation>
    </message>
    <message>
        <source>This run has no prediction: the robot&apos;s place or a reading was not known before Start.</source>
        <translation>Cet essai n’est pas prédit : la position du robot ou une mesure n’était pas connue avant le démarrage.</translation>
    </message>
    <message>
        <source>This run has no prediction: it could not be computed.</source>
        <translation>Cet essai n’est pas prédit : le calcul n’a pas abouti.</translation>
    </message>
    <message>
        <source>Reset waits for the source to cool by %1: it does not cool yet. Switch it off at its mains.</source>
        <translation>Réinitialiser attend que la source ait refroidi de %1 : elle ne refroidit pas encore. Coupez son alimentation secteur.</translation>
    </message>
    <message>
        <source>The source cools: Reset is possible when it has fallen by %1; now %2.</source>
        <translation>La source refroidit : Réinitialiser est possible quand elle aura baissé de %1 ; maintenant %2.</translation>
    </message>
    <message>
        <source>Home the robot: here, or on the page Rig, By hand, where its place can be confirmed instead.</source>
        <translation>Lancez la prise d’origine du robot : ici, ou à la page Banc, À la main, où l’on peut aussi confirmer sa position.</translation>
    </message>
    <message>
        <source>Then Reset, then Arm.</source>
        <translation>Ensuite Réinitialiser, puis Armer.</translation>
    </message>
    <message>
        <source>Home is not possible: no experiment is loaded.</source>
        <translation>La prise d’origine n’est pas possible : aucune expérience n’est chargée.</translation>
    </message>
    <message>
        <source>Home is not possible: a run is armed or on. Stop it first.</source>
        <translation>La prise d’origine n’est pas possible : un essai est armé ou en cours. Arrêtez-le d’abord.</translation>
    </message>
    <message>
        <source>Home is not possible: the robot does not answer.</source>
        <translation>La prise d’origine n’est pas possible : le robot ne répond pas.</translation>
    </message>
    <message>
        <source>This run has no prediction: it is computed while the Run page is shown, and was not ready at Start.</source>
        <translation>Cet essai n’est pas prédit : la prévision se calcule tant que la page Essai est affichée, et elle n’était pas prête au démarrage.</translation>
    </message>
    <message>
        <source>Reset is possible when the robot has come to rest.</source>
        <translation>Réinitialiser est possible quand le robot s’est immobilisé.</translation>
    </message>
</context>
<context>
    <name>bask::ZeroPanel</name>
    <message>
        <source>Offsets: %1.</source>
        <translation>Corrections : %1.</translation>
    </message>
    <message>
        <source>That of %1 is large: check the sensor and its wiring.</source>
        <translation>Celle de %1 est grande : vérifiez le capteur et son câblage.</translation>
    </message>
    <message>
        <source>Not while the heat is on.</source>
        <translation>Pas tant que le chauffage est en marche.</translation>
    </message>
    <message>
        <source>Zeroed on %1 with the room at %2.</source>
        <translation>Ajustés le %1, la pièce étant à %2.</translation>
    </message>
    <message>
        <source>Not zeroed yet: Arm does it, if all objects are at the room&apos;s temperature then.</source>
        <translation>Pas encore ajustés : l’armement le fait, si tous les objets sont alors à la température ambiante.</translation>
    </message>
    <message>
        <source>Sensors at rest</source>
        <translation>Capteurs au repos</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>Ajuster les capteurs</translation>
    </message>
    <message>
        <source>Make all sensors agree while the objects are at the room&apos;s temperature</source>
        <translation>Faire concorder tous les capteurs pendant que les objets sont à la température ambiante</translation>
    </message>
</context>
</TS>
