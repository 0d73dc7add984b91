var a=["000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000","0183100173c7014464g020033d990020005201c02177x13110008207101c44256049090a115011011g42060043720714412922090402706323392100013444h13e1114h2887b4b2f157a31kc102c71038c9153602102022732112864024a010103032072a52b03c1520765109320h8aa5024d00491a483b481a041241b7420707c4ae077320832425943214","87p67zm373b0a4fmf8rfg7vyh1fjwfxpm62n6tactsa4sme3msub3rzxnbtmdvwlghsvnrpo8smbwykkbu1r6mm7samdi27a3l4s62v5tacwgwkxx11yw976n2whu3io4ggfuxo9nuvaizv6r9b7c8y0jot4wyf5m3smt1reznlbqg9gcb2pzv6i65fxp43osg5dz0eweiw8a6flwgm7pssm7p64u6ez22ma94bnbvz3hnoh6pjmag450elxnvv6u8pedahd7lkyegyuf6qil4j","9d0sr8g5e1tniwazi2yupk2bp4j5lmfu5nhdw5izbqd5sr2gs4hjn0xhf3i4a58gu10u6wurnmot3rjkae6ifi1xdmn7uaelmsl6anpaf698cg5dzjwpwf8bpm7ty4vlq51d9hr6222h4sgbku0ujj7tzsm9rzmj0evur98201yyiiomu8axkeupx79ny0w1teunaoilj9lu2x4tzea971dbak3fxxcowtyauy943ka62ikm4cr0orh0iq004xm82kpddif0ztljw8881x37bph","9x258ky66ua1arlkb97nuriu51am22hc1dnfvgl1j3o4mnqbfl4jpif12hovwlyrbrkxbg2q1g7jv9k8qh4bgpwf51rm23p2xjg9di8bnw4s9k8or9yaiwjmecv32lvrkt55ohhb17195z9u0kdhyvgyjayyp4yvav2pog2ye0qjyuj6i2lasyiaj4jf1jl7k8jkgrirc0j517kt81awjgkky219hghfl7t1o4aujdcvqv0z92lspolhgqfla4rwioy560gt2gnzdu2rucp2mhn"],r=0,e=Object.fromEntries(`Zentimeter
weniger als 20 Bilder je Sekunde: langsam fliegen oder die Rate erhöhen
die Wände als .dxf ausgeben
das Leseprogramm für {kind} ({name})
{part} fehlt; zu installieren mit: {name}
{name}: Lesen misslang ({error})
kein Kontakt zu housefly new: Läuft es noch? Was jetzt geschieht, wird nicht gespeichert
ein Raum von {a} x {b} m, {c} m hoch
landet
diese Seite darf den Standort nicht ändern
jede Linie gilt als Wand: Keine Ebene heißt so
es muss zu '{name}' passen
{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne Kompression ausgeben oder pip install DracoPy
{n} {name}
der Entwurf wurde anderswo geändert, in einem anderen Tab oder Terminal: So ist er jetzt; die letzte Änderung noch einmal machen
ist kein bekannter Schlüssel
die Punkte passen wie im Spiegel: Zwei wurden vertauscht, oder das Ortungssystem zählt eine Achse andersherum; sie in der richtigen Reihenfolge neu nehmen oder in seiner Software z nach oben, rechtshändig, wählen
es ist nicht gesagt, wo der Landeplatz liegt, auf dem die Drohne startet und landet
seine Zahlen ({thing}) sind laut Datei je {a} m
{name} antwortet {n}-mal je Sekunde: {words}, Akku {p} %, Firmware {firmware}
{name} hat mehr als {n} Zahlen je Punkt
{words}
außerhalb seiner Wände wird nicht geflogen
ihn verschieben oder weglassen
einen umbenennen
{why}, {more}
der Leser bricht mit {name} ab
{name} umfasst {a} m²; den Teil zum Fliegen ausschneiden
Modell und Adresse angeben, etwa: tello 192.168.10.1
die Punkte neu nehmen
der Name einer pgm- oder png-Datei neben der yaml-Datei
{name} hat Punkte ohne drei Koordinaten
{name}: origin hat yaw {a} rad; nur 0 kann eingelesen werden: das Bild drehen und yaw auf 0 setzen
ist {name}; erlaubt: eine Zahl von {a} bis {b} {unit}
die Drohne passt nirgends hin: Stimmt die Einheit der Datei?
die Punkte liegen {what} innerhalb von {a} m; Punkte nehmen, die {b} m und mehr auseinanderliegen, besser mehrere Meter
eine endliche Zahl angeben
eine Liste x, y, yaw aus drei Zahlen [m, m, rad]
der Boden liegt darin bei {a} m
{name}: {a} m x {b} m, {n} Quader aus {m} Punkten; {ceiling}
die Verbindung zu {name} ging verloren
das Leseprogramm für Scans ({name})
Rest: {names}
fliegt
{a} % seiner {b} m² wurden nie gesehen: unerkundet, wird nicht überflogen (oben änderbar)
den Landeplatz verschieben: ({x}, {y}) m ist geräumig
{name} ist {a} m x {b} m mit unit={c}; erlaubt: {d} bis {e} m: eine andere Einheit angeben
{name} hat Kommazahlen als Bildpunkte; als png oder pgm mit je 8 Bit speichern
m je Bildpunkt
seine Zahlen ({a} x {b}) gelten als {words}, ein Raum von {c} m x {d} m: eine Wand messen und die Einheit angeben, wenn sie nicht so lang ist
{name} kann nicht als Scan gelesen werden: {why}; ist die Datei vollständig?
{name} bei ({x}, {y}, {z}) m, Richtung {a}°, in {n} % der Bilder
wahr oder falsch angeben
mehr als {n} Formen; weglassen, was keine Wand ist
seine Zahlen ({a} x {b}) können nicht „{words}“ sein und gelten als {then}, ein Raum von {c} m x {d} m: eine Wand messen und die Einheit angeben, wenn sie nicht so lang ist
Grau 205 gilt als nie gesehen, obwohl free_thresh ({a}) es frei nennt: map_saver schreibt es dafür
{name} enthält keine Linien: Sind die Wände als Linien oder Formen gezeichnet, nicht als Bild?
{name} hat mehr als 16 Bit je Bildpunkt; als png oder pgm mit 8 speichern
0 oder 1
den Scan als .ply oder .e57 ausgeben
{name} und {n} weitere
erlaubt: {names}
Zeichnung 1:{n}
eine ganze Zahl angeben
{name} kann nicht gelesen werden: {why}; die Datei berichtigen oder entfernen
{name}: {a} m x {b} m, {n} Linien wurden Wände bis zur Decke (auch Türen und Fenster, wo sie auf derselben Ebene liegen)
{n} Dateien sind schon hier: die Seite neu starten
{name} hat keinen guten Kopf einer LAS-Datei; ist die Datei vollständig?
{name} sendet mit y nach oben; in der Ortungssoftware z nach oben wählen
{name} sendet mehr als {n} Bilder je Sekunde; der Rest fällt weg
die Drohne kann bei {place}, ({x}, {y}) m nicht schweben: {why}
das nächste Hindernis ist {a} m entfernt, und die Drohne hält {b} m Abstand
eine Zahl angeben
eine ganze Zahl angeben
den Scan als .glb oder .ply ausgeben
die eigene vermessen: housefly identify (docs/identify-and-gains.md)
den Grundriss als .svg oder .dxf ausgeben
zwei Punkte können einander nicht prüfen: einen dritten nehmen
{why}; {more}
Fuß
die Zone {name} bedeckt den Landeplatz
ein neuer Treiber fand sie in der Luft: sie schwebt nur und landet
aber: {why}
zwei Punkte sind nötig und ein dritter, um sie zu prüfen
etwas steht {a} m von der Mitte des Landeplatzes auf dem Boden, und die Drohne startet mit {b} m und mehr um sich
{name} kann nicht als SVG gelesen werden: {why}
{name} hat {a} m mal {b} m; erlaubt: bis {c} m je Seite
x_min muss unter x_max liegen und y_min unter y_max [m]
es gibt keinen Ort zum Hinfliegen
von {name} kam nichts
seine Zahlen ({a} x {b}) sind {words}: eine Wand messen und die Einheit angeben, wenn sie nicht so lang ist
die Höhe des Raums berichtigen oder flight_height senken
{name} hat {n} Punkte; mindestens {m} sind nötig, besser einer je 2 cm Wand und Boden
{name} kann nicht als .old aufgehoben werden: {why}
geräumige Stellen
mehr als {n} Blöcke sind eingefügt; weglassen, was keine Wand ist
{kind} von {name}, das nicht darin ist
die Datei endet mittendrin: {n} Punkte fehlen
das Bild der Karte {name} kann nicht gelesen werden: {why}; erlaubt: pgm oder png
mindestens ein Zeichen
eine Liste angeben
die Datei heißt {name}; erlaubt: bis zu 100 Buchstaben, Ziffern, Leerzeichen und . _ - + ( ), vorn ein Buchstabe oder eine Ziffer
es liegt hinter einer Wand oder in etwas
Gruppen sind mehr als {n} Ebenen tief verschachtelt
unter {name} antwortet nach {n} s keine Drohne: ist sie eingeschaltet und der Rechner in ihrem WLAN?
{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne Kompression und Quantisierung ausgeben
{name} hat den Text {thing}, gelesen als Zahl {n}
{name} gilt als oben
der Raum beginnt bei (0, 0), was die ROS-Karte ({x}, {y}) m nennt
höchstens {n} Einträge, nicht {m} ({kind})
{name} enthält keine Punkte oder keine endlichen
eine ganze Zahl angeben
ausgelassen: {names} ({words})
vom Landeplatz ist keine weitere geräumige Stelle erreichbar
die Drohne behält {setting} = {kept} statt {wanted}
Daten kommen nicht von {name}; in tracking.address {other} eintragen
von {name} kam kein Bericht
was unter {name} antwortet, spricht nicht {protocol} ({error})
die Drohne passt nirgends in diesen Raum: Gibt es freien Boden?
die Punkte liegen auf einer Linie: Eine andersherum gezählte Achse fiele nicht auf; noch einen daneben nehmen
ausgelassen: {n} Punkte, die sie Rauschen nennt
kein Ebenenname enthält {name}; es gibt: {thing}
{name} ist keine yaml-Datei: {why}
ist {name}; {words}
von {name} kommen Bilder, doch ihre Zeit steht; ist {what} angehalten?
höchstens {n} Zeichen
Decke {c} m
fehlt
{name} misst {thing}: alle Punkte liegen auf einer Linie oder Ebene
größer als {n}
zu viel; erlaubt: {n} MiB
nicht erreicht: {why}
seine Zahlen ({thing}) gelten als {words}
der Raum hat noch keine Größe
weiter zurück geht es nicht
{name} enthält weder Punkte noch Flächen
die Datei ist beschädigt; behobene oder ausgelassene Fehler: {n}
ist der Text {thing}
{name} kann nicht gelesen werden: {why}; die yaml-Datei der Karte angeben
{name}: {a} m x {b} m, {n} Quader; eine ROS-Karte ist flach, deshalb reichen ihre Wände vom Boden bis zur Decke
dieser Browser hat keine Sitzung
mehr als {n} Elemente; weglassen, was keine Wand ist
{name} hat keinen guten Kopf einer PCD-Datei: {why}
{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne Kompression ausgeben
jede Linie gilt als Wand: Keine Ebene heißt so; die Ebenen angeben, wenn nur manche Wände enthalten: {name}
nichts gehört: {why}
einen Text angeben
die Einheit der Datei oder die Größe prüfen: Sind es Meter? Oder Möbel und Zonen herausnehmen
hebt ab
mit {name} verbunden, doch es kommt nichts
der Raum hat keine Wände
eine Zahl angeben
{name} endet mittendrin: {a} von {b} Bytes sind da
{n} Quader und mehr wären nötig, höchstens {m} gehen: den Teil zum Fliegen ausschneiden und von einzelnen Punkten säubern
einen benennen und angeben, wo er ist
mindestens {n}
ausgelassen: {n} von {m} Punkten ({words})
nicht lesbar
nichts wurde gespeichert: {why}
sind es Millimeter? In der Ortungssoftware Meter wählen
die yaml-Datei der Karte angeben, die das Bild nennt
keiner
{name} kann nicht geschrieben werden: {why}
{name} hat mehr als {n} MB; den Scan ausdünnen, 2 cm zwischen den Punkten genügen
der Raum beginnt bei (0, 0), was der Scan ({x}, {y}) m nennt
der Ortungsrahmen hat seinen Ursprung bei ({x}, {y}, {z}) m auf der Karte, gedreht um {a}°
{name} zeigt nach oben, wie angegeben
{name} ist keine yaml-Datei einer Karte: die Schlüssel image, resolution und origin fehlen
für die Ortung
{name} kann nicht gelesen werden: das Leseprogramm brach ab; ist die Datei vollständig?
die Drohne passt nirgends hin: {a} % des Bodens wurden nie gesehen
seine Außenwände schließen nicht, also sagt nichts, was außen ist: die Karte ansehen und fehlende Wände zeichnen
Art und Adresse angeben, etwa: vicon 10.0.0.5
zuerst angeben, wo die Drohne antwortet
kein bekannter Schlüssel
verborgen oder auf einer gefrorenen oder ausgeschalteten Ebene
eine geräumige Stelle
der Boden
höchstens {n}
kleiner als {n}
{name}: die Karte umfasst mehr als {a} m²; den Teil zum Fliegen ausschneiden
ein Rechteck ist x_min, y_min, x_max, y_max [m] mit x_min < x_max und y_min < y_max
der Browser ging, bevor die ganze Datei da war
ist {thing}
angeben, wo: ({x}, {y}) m ist geräumig
die Datei kann nicht gespeichert werden: {why}
Meter
rect so groß wie die Seite
gelandet
ihre Punkte liegen etwa {a} cm auseinander: Zellen von {b} cm
die Punkte stimmen nicht auf {n} cm überein, am schlechtesten {name}: die Drohne dort neu hinlegen und messen oder die Stelle auf der Karte neu messen
die Drohne passt nirgends in diesen Raum
der Prozess des Raums antwortet nicht (Protokoll: room.log)
die Punkte von {name} liegen mehr als {a} cm auseinander, zu wenig, um Wände von Lücken zu unterscheiden: dichter ausgeben, am besten alle 2 cm, oder als Flächen; oder ist die Einheit eine andere?
zuerst angeben, welches System es ist und wo es antwortet
{name} zeigt nach oben, wie das Format es hat
unbekannt
die Datei endet mittendrin: Sie wurde abgeschnitten
{name}: die Karte hat keinen freien Bildpunkt; negate (0 oder 1) und free_thresh prüfen
{name} ist weiter weg, als ein Raum lang ist: {ask}
die Drohne kann bei ({x}, {y}) m nicht starten: {why}
Zoll, wie die Datei Längen schreibt
keine Zahlen
noch nicht mit {name} verbunden
{name} {n} cm
Posen werden abgelehnt, {pose}: {ask}
die Ortung sieht einen Meter als {a} m: die Punkte neu messen; kommt es wieder, die Kameras kalibrieren oder in der Ortungssoftware Meter einstellen
{name} misst {a} x {b}: in keiner üblichen Einheit ein Raum; angeben, wie viele Meter eine Einheit ist
{name} braucht {thing}, das nicht daneben liegt: beide Dateien wählen oder als ein .glb ausgeben
{name}: {key} {found}; erlaubt: {words}
{name} ist keine Datei; den Namen prüfen
mindestens {n} Zeichen
die Decke ({a} m) liegt weniger als 0,4 m über der Flughöhe ({b} m)
Notaus
ist {a}; erlaubt: {b} bis {c} Meter je Einheit der Datei
{name}: free_thresh ({a}) muss unter occupied_thresh ({b}) liegen
{name} hat {n} x {m} Bildpunkte; höchstens {p} je Seite können eingelesen werden
{words} {unit}
map.flight_height ({a} m) muss in limits.height_min..height_max ({b} .. {c} m) liegen
{name} hat keinen guten Kopf einer E57-Datei; ist die Datei vollständig?
die Standortdatei hält es frei
Länge x Breite x Höhe in Metern angeben (6x4x2.5) oder eine Datei des Raums
keine Linien oder Formen
es ist nicht gesagt, welches Ortungssystem die Drohne sieht
Millimeter
wiederholt
der Körper der Drohne {name} ist nicht dabei (gesehen: {names}): ihre Marker freilegen oder ihren Namen so angeben, wie ihn die Ortungssoftware hat
es ist nicht gesagt, wo die Drohne antwortet
{a} x {b} x {c}
Blöcke sind mehr als {n} Ebenen tief verschachtelt
auf Ebenen ohne Wände
Decke {c} m (nicht im Scan: wie üblich)
{name} gelesen
mit {name} verbunden, doch es kommt nichts Neues; läuft {what}, ohne Pause?
{name} ist größer als {n} MiB: den Scan erst ausdünnen, 5 cm zwischen den Punkten genügen
{name} sendet {n} Bilder je Sekunde
die Drohne hat ihre Grenzwerte noch nicht bestätigt
je {c} m, wie die Datei sagt
unerkundeter Boden gilt als frei, wie angegeben
{names} (die Karte neu speichern)
ist kein bekannter Schlüssel: Ist {names} gemeint?
Wände stammen aus den Ebenen {name}
{why}: {more}
image ist {thing}, das es nicht gibt: Gelesen wurde {name} neben der yaml-Datei
eine Zahl von {a} bis {b} {unit}
sie zeichnen oder die Größe neu angeben: Ein Rechteck bringt seine vier Wände mit
{name} definiert Entitäten; als einfaches SVG speichern
{name} hat {n} Linien, höchstens {m} werden gelesen: angeben, welche Ebenen die Wände enthalten; es gibt: {thing}
auf der Karte
diesen Wert berichtigen
{name} enthält {n} Punkte, höchstens {m} werden gelesen: den Scan ausdünnen, 2 cm zwischen den Punkten genügen
{name} ist keine yaml-Datei einer Karte: erlaubt sind {n} Zeichen und {m} Klammern
eine Zahl von {a} bis {b}
niemand antwortet unter {name}; läuft {what}, und sendet es?
rückgängig gemacht
{name} kann nicht als DXF gelesen werden: {why}
hier drei Punkte nehmen oder die Drohne tragen: housefly preflight --frames --site SITE
ausgelassen: {n} Teile, die weder Punkte noch Flächen sind
sie {a} m von ({x}, {y}) m entfernt halten
Zoll
eine Einheit ist {a} m, wie angegeben
der Raum hat noch keine Größe: Länge und Breite angeben oder eine Datei
zwei Orte heißen {place}
2 cm und kleiner
{name} hat kein Feld {thing}; es hat: {place}
{name} ist beschädigt: Die Punkte sind nicht so lang wie angegeben
es fehlt
die Drohne fliegt mit den Konstanten einer üblichen {name}
ist {name}; erlaubt: eine Zahl von {a} bis {b}
entfernt
niemand hat den Ortungsrahmen bisher mit der Karte verglichen
{name} kann nicht gelesen werden: {why}
{n} weitere
{name} misst {thing}: in keiner üblichen Einheit ein Raum; angeben, wie viele Meter eine Einheit ist (0.001 für Millimeter) und welche Achse nach oben zeigt
{name}: Aus so einer Datei wird kein Raum gelesen; {words}; erlaubt: {thing}
{name}: aus so einer Datei wird kein Raum gelesen; erlaubt: {thing}
kein Weg führt von zu Hause dorthin
weit weg von allem anderen
{name} kam nicht an: die Datei noch einmal wählen`.split(`
`).map((n,i)=>[r+=parseInt(a.map(t=>t[i]).join(""),36),n]));var s={"New site":"Neuer Standort","Waiting for the draft …":"Warten auf den Entwurf …",Steps:"Schritte","new site: {name}":"neuer Standort: {name}","without a name":"ohne Namen",Undo:"Rückgängig",Redo:"Wiederholen","△ Not kept":"△ Nicht gespeichert","Keeping …":"Speichern …","Kept; checking where one can fly …":"Gespeichert; es wird geprüft, wo man fliegen kann …","Everything is kept.":"Alles ist gespeichert.","Next: {title}":"Weiter: {title}","Bringing {file} …":"{file} wird übertragen …","Remove {name}":"{name} entfernen",Remove:"Entfernen",Done:"Fertig",Name:"Name",Address:"Adresse",Room:"Raum","Walls and furniture":"Wände und Möbel",Pad:"Landeplatz",Places:"Orte","No-fly zones":"Verbotszonen",Tracking:"Ortung","Tracking frame":"Ortungsrahmen",Drone:"Drohne","Write the site":"Standort schreiben","Wall {k}, {d} m":"Wand {k}, {d} m","point {k}":"Punkt {k}","at {x}, {y} m":"bei {x}, {y} m","{n} point|{n} points":"{n} Punkt|{n} Punkte","no points":"keine Punkte","{n} piece|{n} pieces":"{n} Möbelstück|{n} Möbelstücke","{n} wall|{n} walls":"{n} Wand|{n} Wände","no walls":"keine Wände","no furniture":"keine Möbel","{n} boxes of a file":"{n} Quader einer Datei","{a} × {b} m, {h} m high":"{a} × {b} m, {h} m hoch",simulated:"simuliert","{kind} at {address}":"{kind} unter {address}",none:"keine","Floor plan":"Grundriss","Floor plan. Tab reaches what the open step draws; arrow keys move it.":"Grundriss. Tab erreicht, was der offene Schritt zeichnet; Pfeiltasten bewegen es.","Give the room a size first.":"Zuerst die Größe des Raums angeben.","too close to fly":"zu nah zum Fliegen","Drag to draw; tap what is drawn to move it.":"Ziehen zeichnet; Gezeichnetes antippen, um es zu bewegen.","Tap where the pad lies; pull its line to where the nose looks.":"Antippen, wo der Landeplatz liegt; seine Linie dorthin ziehen, wohin die Nase zeigt.","Tap for a new place; pull its line to what it looks at.":"Für einen neuen Ort tippen; seine Linie zu dem ziehen, was er ansieht.","Drag over what is to be kept free.":"Über das ziehen, was frei bleiben soll.","Tap where a point lies on the floor.":"Antippen, wo ein Punkt auf dem Boden liegt.","Name of the site":"Name des Standorts","my lab":"mein Labor","An empty rectangle [m]":"Ein leeres Rechteck [m]","length (x)":"Länge (x)","width (y)":"Breite (y)",ceiling:"Decke","Make this room":"Diesen Raum anlegen","Change the size":"Größe ändern","Four new walls take the place of those that are drawn.":"Vier neue Wände ersetzen die gezeichneten.","Or a file of it":"Oder eine Datei davon","ROS map (yaml and its picture), scan (ply, gltf, las, e57 …), plan (svg, dxf)":"ROS-Karte (yaml und ihr Bild), Scan (ply, obj, gltf, e57, las, pcd …), Grundriss (svg, dxf)","Unit of the file":"Einheit der Datei","Up in a scan":"Oben im Scan","Floor that was never seen is":"Boden, der nie gesehen wurde, ist","a wall":"eine Wand","free floor":"freier Boden","found out":"automatisch",metres:"Meter",centimetres:"Zentimeter",millimetres:"Millimeter",inches:"Zoll",feet:"Fuß","Layers of the plan that hold the walls (may be empty)":"Ebenen des Plans mit den Wänden (darf leer sein)","walls, windows":"Wände, Fenster","None of these is a room: choose the yaml, the scan or the plan too.":"Keine davon ist ein Raum: auch die yaml-Datei, den Scan oder den Plan wählen.","Read {file}":"{file} lesen","Read it":"Lesen","Reading {file} …":"{file} wird gelesen …","Read from {file}.":"Gelesen aus {file}.","The drone flies at [m]":"Die Drohne fliegt auf [m]","height above the floor":"Höhe über dem Boden","A drag on the plan":"Ziehen auf dem Grundriss",Move:"Bewegen","Draw walls":"Wände zeichnen","Draw furniture":"Möbel zeichnen","Erase scan":"Scan radieren","{n} boxes come from the file; “Erase scan” takes out what moved since.":"{n} Quader stammen aus der Datei; „Scan radieren“ entfernt, was seither bewegt wurde.","Kind of furniture":"Art des Möbels","{name}, {d} m high":"{name}, {d} m hoch",table:"Tisch",chair:"Stuhl",sofa:"Sofa",bed:"Bett",shelf:"Regal",cupboard:"Schrank",box:"Kiste","Add a wall":"Wand hinzufügen","Add a {name}":"{name} hinzufügen",Furniture:"Möbel",Walls:"Wände","From, to [m]":"Von, bis [m]","x from":"x von","y from":"y von","x to":"x bis","y to":"y bis","Thickness and heights [m]":"Dicke und Höhen [m]",thickness:"Dicke",bottom:"unten",top:"oben","up to the ceiling":"bis zur Decke","Middle and size [m]":"Mitte und Größe [m]",length:"Länge",width:"Breite","Heights [m], turn [°]":"Höhen [m], Drehung [°]",turned:"gedreht","Choose a roomy spot":"Geräumige Stelle wählen","Looking for a roomy spot …":"Geräumige Stelle wird gesucht …","Put it in the middle":"In die Mitte legen","Pad [m], nose [°]":"Landeplatz [m], Nase [°]","nose looks to":"Nase zeigt nach","The drone starts and lands there. 0° is along x, 90° along y.":"Dort startet und landet die Drohne. 0° ist entlang x, 90° entlang y.","Add a place":"Ort hinzufügen","Choose roomy spots":"Geräumige Stellen wählen","Looking for roomy spots …":"Geräumige Stellen werden gesucht …",Place:"Ort","Reading corner":"Leseecke","In commands: {name}":"In Befehlen: {name}","Hovers at [m]":"Schwebt bei [m]","Looks at [m]":"Blickt auf [m]",height:"Höhe","looks away from the pad":"blickt vom Landeplatz weg","Add a zone":"Zone hinzufügen","None are needed: walls and furniture are kept away from anyway.":"Keine ist nötig: Von Wänden und Möbeln wird ohnehin Abstand gehalten.",Reason:"Grund","Wet floor":"Nasser Boden","kept free":"freigehalten","Kept free [m]":"Freigehalten [m]","What flies":"Was fliegt","All simulated":"Alles simuliert","Real hardware":"Echte Geräte","Drone and tracking are simulated: try the room first.":"Drohne und Ortung sind simuliert: erst den Raum ausprobieren.","What is real can be said later.":"Was echt ist, kann später angegeben werden.",System:"System","another, by motioncapture":"ein anderes, über motioncapture","as usual":"wie üblich",Port:"Port","Its type in motioncapture":"Sein Typ in motioncapture","The drone's name there":"Name der Drohne dort","Axis up":"Achse nach oben","Begins by":"Beginnt mit","Listen for {n} s":"{n} s zuhören","Listening …":"Zuhören …","Which one is the drone":"Welche davon ist die Drohne","The simulated tracking system uses the map's frame.":"Die simulierte Ortung benutzt den Rahmen der Karte.","Lay the drone on three points of the floor that are far from each other.":"Die Drohne auf drei weit voneinander entfernte Punkte des Bodens legen.","For each, say where it is on the map, and take where tracking sees the drone.":"Für jeden angeben, wo er auf der Karte liegt, und übernehmen, wo die Ortung die Drohne sieht.","Add a point":"Punkt hinzufügen",Points:"Punkte","What the points say":"Was die Punkte sagen","On the map [m]":"Auf der Karte [m]","As tracking sees it [m]":"Wie die Ortung ihn sieht [m]","Take what tracking sees now":"Übernehmen, was die Ortung jetzt sieht","The drone is simulated; “Tracking” says what flies.":"Die Drohne ist simuliert; „Ortung“ sagt, was fliegt.","Profile of housefly identify (may be empty)":"Profil von housefly identify (darf leer sein)","Ask the drone":"Drohne fragen","Asking the drone …":"Die Drohne wird gefragt …","Nothing turns: it is only asked how it is.":"Nichts dreht sich: Sie wird nur gefragt, wie es ihr geht.","What the steps above still lack has to be said first.":"Zuerst muss angegeben werden, was den Schritten oben noch fehlt.","Room and site are written as files that you can read and change.":"Raum und Standort werden als Dateien geschrieben, die man lesen und ändern kann.","Writing …":"Schreiben …","Written to {folder}. In a terminal:":"Geschrieben nach {folder}. In einem Terminal:","Is this machine fit for it?":"Ist dieser Rechner dafür geeignet?","The whole thing, simulated":"Das Ganze, simuliert","Before the first flight, the drone in your hands":"Vor dem ersten Flug, die Drohne in der Hand","The real room":"Der echte Raum"},m={texts:s,templates:e};export{m as DE};
