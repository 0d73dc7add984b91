// What the server of the page of a new site says, in German: templates of its sentences.
import type { Templates } from "../../messages/speech";

export const DE_TOLD: Templates = {
  // what a draft lacks, and what mends it
  "the room has no size yet": "der Raum hat noch keine Größe",
  "give length x width x height in metres (6x4x2.5), or a file of the room":
    "Länge x Breite x Höhe in Metern angeben (6x4x2.5) oder eine Datei des Raums",
  "the room has no size yet: give its length and width, or a file":
    "der Raum hat noch keine Größe: Länge und Breite angeben oder eine Datei",
  "x_min must be below x_max, and y_min below y_max [m]":
    "x_min muss unter x_max liegen und y_min unter y_max [m]",
  "correct that value": "diesen Wert berichtigen",
  "the ceiling ({a} m) is less than 0.4 m above the flight height ({b} m)":
    "die Decke ({a} m) liegt weniger als 0,4 m über der Flughöhe ({b} m)",
  "correct the height of the room, or lower flight_height":
    "die Höhe des Raums berichtigen oder flight_height senken",
  "the room has no walls": "der Raum hat keine Wände",
  "draw them, or give the size again: a rectangle brings its four walls":
    "sie zeichnen oder die Größe neu angeben: Ein Rechteck bringt seine vier Wände mit",
  "the drone fits nowhere in this room": "die Drohne passt nirgends in diesen Raum",
  "the drone fits nowhere in this room: is there a free floor?":
    "die Drohne passt nirgends in diesen Raum: Gibt es freien Boden?",
  "check the unit of the file or the size: are they metres? Or take furniture and zones out":
    "die Einheit der Datei oder die Größe prüfen: Sind es Meter? Oder Möbel und Zonen herausnehmen",
  "it is not said where the pad lies, on which the drone starts and lands":
    "es ist nicht gesagt, wo der Landeplatz liegt, auf dem die Drohne startet und landet",
  "say where: ({x}, {y}) m is roomy": "angeben, wo: ({x}, {y}) m ist geräumig",
  "move the pad: ({x}, {y}) m is roomy": "den Landeplatz verschieben: ({x}, {y}) m ist geräumig",
  "the drone cannot start at ({x}, {y}) m: {why}":
    "die Drohne kann bei ({x}, {y}) m nicht starten: {why}",
  "the drone cannot hover at {place}, ({x}, {y}) m: {why}":
    "die Drohne kann bei {place}, ({x}, {y}) m nicht schweben: {why}",
  "no way leads there from home": "kein Weg führt von zu Hause dorthin",
  "the site file keeps it free by order": "die Standortdatei hält es frei",
  "it is behind a wall or inside something": "es liegt hinter einer Wand oder in etwas",
  "the nearest obstacle is {a} m away and the drone keeps {b} m":
    "das nächste Hindernis ist {a} m entfernt, und die Drohne hält {b} m Abstand",
  ["something stands on the floor {a} m from the middle of the pad, and the drone " +
      "starts with {b} m and more around it"]:
    "etwas steht {a} m von der Mitte des Landeplatzes auf dem Boden, und die Drohne " +
      "startet mit {b} m und mehr um sich",
  "there is no place to fly to": "es gibt keinen Ort zum Hinfliegen",
  "name one and say where it is": "einen benennen und angeben, wo er ist",
  "two places are called {place}": "zwei Orte heißen {place}",
  "rename one": "einen umbenennen",
  "move it, or leave it out": "ihn verschieben oder weglassen",
  "the zone {name} covers the pad": "die Zone {name} bedeckt den Landeplatz",
  "keep it {a} m away from ({x}, {y}) m": "sie {a} m von ({x}, {y}) m entfernt halten",
  "it is not said which motion capture system sees the drone":
    "es ist nicht gesagt, welches Ortungssystem die Drohne sieht",
  "say its kind and address, such as: vicon 10.0.0.5":
    "Art und Adresse angeben, etwa: vicon 10.0.0.5",
  "nobody compared the tracking frame with the map yet":
    "niemand hat den Ortungsrahmen bisher mit der Karte verglichen",
  "take three points here, or carry the drone: housefly preflight --frames --site SITE":
    "hier drei Punkte nehmen oder die Drohne tragen: housefly preflight --frames --site SITE",
  "take the points again": "die Punkte neu nehmen",
  "it is not said where the drone answers": "es ist nicht gesagt, wo die Drohne antwortet",
  "say its model and its address, such as: tello 192.168.10.1":
    "Modell und Adresse angeben, etwa: tello 192.168.10.1",
  "the drone flies with the constants of a usual {name}":
    "die Drohne fliegt mit den Konstanten einer üblichen {name}",
  "measure yours: housefly identify (docs/identify-and-gains.md)":
    "die eigene vermessen: housefly identify (docs/identify-and-gains.md)",
  // the points of the tracking frame
  "the tracking frame has its origin at ({x}, {y}, {z}) m on the map, turned by {a} deg":
    "der Ortungsrahmen hat seinen Ursprung bei ({x}, {y}, {z}) m auf der Karte, gedreht um {a}°",
  ["the points fit as in a mirror: two were exchanged, or the tracking system counts " +
      "one axis the other way; take them again in the right order, or choose z up, " +
      "right-handed, in its software"]:
    "die Punkte passen wie im Spiegel: Zwei wurden vertauscht, oder das Ortungssystem " +
      "zählt eine Achse andersherum; sie in der richtigen Reihenfolge neu nehmen oder in " +
      "seiner Software z nach oben, rechtshändig, wählen",
  ["tracking sees a metre as {a} m: measure the points again; if it comes again, " +
      "calibrate the cameras or set metres in the tracking software"]:
    "die Ortung sieht einen Meter als {a} m: die Punkte neu messen; kommt es wieder, die " +
      "Kameras kalibrieren oder in der Ortungssoftware Meter einstellen",
  ["the points do not agree to {n} cm, {name} worst: put the drone there again and " +
      "measure, or measure its place on the map again"]:
    "die Punkte stimmen nicht auf {n} cm überein, am schlechtesten {name}: die Drohne dort " +
      "neu hinlegen und messen oder die Stelle auf der Karte neu messen",
  ["the points lie on one line: an axis that is counted the other way would not show; " +
      "take one more beside it"]:
    "die Punkte liegen auf einer Linie: Eine andersherum gezählte Achse fiele nicht auf; " +
      "noch einen daneben nehmen",
  "two points cannot check each other: take a third":
    "zwei Punkte können einander nicht prüfen: einen dritten nehmen",
  "two points are needed, and a third to check them":
    "zwei Punkte sind nötig und ein dritter, um sie zu prüfen",
  // what was done, and what was not
  "a room of {a} x {b} m, {c} m high": "ein Raum von {a} x {b} m, {c} m hoch",
  "read {name}": "{name} gelesen",
  "erased": "entfernt",
  "a roomy spot": "eine geräumige Stelle",
  "roomy spots": "geräumige Stellen",
  "undone": "rückgängig gemacht",
  "done again": "wiederholt",
  "there is nothing more to go back to": "weiter zurück geht es nicht",
  "no further roomy spot can be reached from the pad":
    "vom Landeplatz ist keine weitere geräumige Stelle erreichbar",
  ["the draft was changed elsewhere, in another tab or in a terminal: this is how it is " +
      "now; make your last change again"]:
    "der Entwurf wurde anderswo geändert, in einem anderen Tab oder Terminal: So ist er " +
      "jetzt; die letzte Änderung noch einmal machen",
  "no contact with `housefly new`: does it still run? What you do now is not kept":
    "kein Kontakt zu housefly new: Läuft es noch? Was jetzt geschieht, wird nicht gespeichert",
  "say first which system it is, and where it answers":
    "zuerst angeben, welches System es ist und wo es antwortet",
  "say first where the drone answers": "zuerst angeben, wo die Drohne antwortet",
  "this browser has no session": "dieser Browser hat keine Sitzung",
  "this page may not change the site": "diese Seite darf den Standort nicht ändern",
  "too much; allowed: {n} MiB": "zu viel; erlaubt: {n} MiB",
  "the browser left before the whole file was here":
    "der Browser ging, bevor die ganze Datei da war",
  "the file cannot be kept: {why}": "die Datei kann nicht gespeichert werden: {why}",
  "nothing was kept: {why}": "nichts wurde gespeichert: {why}",
  "{name} did not arrive: choose the file again":
    "{name} kam nicht an: die Datei noch einmal wählen",
  "{n} files are here already: start the page again":
    "{n} Dateien sind schon hier: die Seite neu starten",
  "{name} is larger than {n} MiB: thin the scan out first, 5 cm between its points are enough":
    "{name} ist größer als {n} MiB: den Scan erst ausdünnen, 5 cm zwischen den Punkten genügen",
  ["the file is called {name}; allowed: up to 100 letters, digits, spaces and . _ - + ( " +
      "), a letter or digit first"]:
    "die Datei heißt {name}; erlaubt: bis zu 100 Buchstaben, Ziffern, Leerzeichen und . _ " +
      "- + ( ), vorn ein Buchstabe oder eine Ziffer",
  // a value that is not allowed
  "is not a known key": "ist kein bekannter Schlüssel",
  "is missing": "fehlt",
  "is {name}; {words}": "ist {name}; {words}",
  "input should be less than or equal to {n}": "höchstens {n}",
  "input should be greater than or equal to {n}": "mindestens {n}",
  "input should be greater than {n}": "größer als {n}",
  "input should be less than {n}": "kleiner als {n}",
  "input should be a valid number": "eine Zahl angeben",
  "input should be a valid number, unable to parse string as a number": "eine Zahl angeben",
  "unexpected keyword argument": "kein bekannter Schlüssel",
  "map.flight_height ({a} m) must lie in limits.height_min..height_max ({b} .. {c} m)":
    "map.flight_height ({a} m) muss in limits.height_min..height_max ({b} .. {c} m) liegen",
  "input should be a finite number": "eine endliche Zahl angeben",
  "input should be a valid integer, got a number with a fractional part": "eine ganze Zahl angeben",
  "string should have at least 1 character": "mindestens ein Zeichen",
  "string should have at most {n} characters": "höchstens {n} Zeichen",
  // what a tracking system and a drone say
  "heard nothing: {why}": "nichts gehört: {why}",
  "{name} sends {n} frames a second": "{name} sendet {n} Bilder je Sekunde",
  "{name} at ({x}, {y}, {z}) m, heading {a} deg, in {n} % of the frames":
    "{name} bei ({x}, {y}, {z}) m, Richtung {a}°, in {n} % der Bilder",
  "but: {why}": "aber: {why}",
  ["the drone's body {name} is not among them (seen: {names}): uncover its markers, " +
      "or say its name as the tracking software has it"]:
    "der Körper der Drohne {name} ist nicht dabei (gesehen: {names}): ihre Marker " +
      "freilegen oder ihren Namen so angeben, wie ihn die Ortungssoftware hat",
  "none": "keiner",
  "fewer than 20 frames a second: fly slowly, or raise the rate":
    "weniger als 20 Bilder je Sekunde: langsam fliegen oder die Rate erhöhen",
  "not reached: {why}": "nicht erreicht: {why}",
  "no report came from {name}": "von {name} kam kein Bericht",
  "unknown": "unbekannt",
  "landed": "gelandet",
  "taking off": "hebt ab",
  "flying": "fliegt",
  "landing": "landet",
  "emergency": "Notaus",
  // what a file holds, and why it cannot be read
  "the drone fits nowhere: is the unit of the file right?":
    "die Drohne passt nirgends hin: Stimmt die Einheit der Datei?",
  ["{name}: {a} m x {b} m, {n} boxes; a ROS map is flat, so its walls reach from the " +
      "floor to the ceiling"]:
    "{name}: {a} m x {b} m, {n} Quader; eine ROS-Karte ist flach, deshalb reichen ihre " +
      "Wände vom Boden bis zur Decke",
  "the room begins at (0, 0), which the ROS map calls ({x}, {y}) m":
    "der Raum beginnt bei (0, 0), was die ROS-Karte ({x}, {y}) m nennt",
  "the room begins at (0, 0), which the scan calls ({x}, {y}) m":
    "der Raum beginnt bei (0, 0), was der Scan ({x}, {y}) m nennt",
  "walls are taken from the layers {name}": "Wände stammen aus den Ebenen {name}",
  "every line is taken for a wall: no layer is called so":
    "jede Linie gilt als Wand: Keine Ebene heißt so",
  "one unit is {a} m, as you said": "eine Einheit ist {a} m, wie angegeben",
  "its numbers ({thing}) were taken for {words}": "seine Zahlen ({thing}) gelten als {words}",
  "metres": "Meter",
  "centimetres": "Zentimeter",
  "millimetres": "Millimeter",
  "inches": "Zoll",
  ["its outer walls do not close, so nothing says what is outside: look at the map, and " +
      "draw walls where they are missing"]:
    "seine Außenwände schließen nicht, also sagt nichts, was außen ist: die Karte ansehen " +
      "und fehlende Wände zeichnen",
  "what is outside of its walls is not flown in": "außerhalb seiner Wände wird nicht geflogen",
  ["{name}: {a} m x {b} m, {n} lines became walls up to the ceiling (doors and windows " +
      "too, where they are drawn on the same layer)"]:
    "{name}: {a} m x {b} m, {n} Linien wurden Wände bis zur Decke (auch Türen und Fenster, " +
      "wo sie auf derselben Ebene liegen)",
  "{name} points up, as you said": "{name} zeigt nach oben, wie angegeben",
  "{name} was taken to point up": "{name} gilt als oben",
  "{name} holds no lines: are its walls drawn as lines or shapes, not as a picture?":
    "{name} enthält keine Linien: Sind die Wände als Linien oder Formen gezeichnet, nicht " +
      "als Bild?",
  "{name} has {n} lines, at most {m} are read: say which layers hold the walls; it has: {thing}":
    "{name} hat {n} Linien, höchstens {m} werden gelesen: angeben, welche Ebenen die Wände " +
      "enthalten; es gibt: {thing}",
  "no layer's name holds {name}; there are: {thing}":
    "kein Ebenenname enthält {name}; es gibt: {thing}",
  "{name} is {a} m x {b} m with unit={c}; allowed: {d} to {e} m: say another unit":
    "{name} ist {a} m x {b} m mit unit={c}; erlaubt: {d} bis {e} m: eine andere Einheit angeben",
  ["{name} measures {thing}: no room in any usual unit; say how many metres one unit is " +
      "(0.001 for millimetres), and which axis points up"]:
    "{name} misst {thing}: in keiner üblichen Einheit ein Raum; angeben, wie viele Meter " +
      "eine Einheit ist (0.001 für Millimeter) und welche Achse nach oben zeigt",
  "{name} has {n} points; at least {m} are needed, better one on each 2 cm of wall and floor":
    "{name} hat {n} Punkte; mindestens {m} sind nötig, besser einer je 2 cm Wand und Boden",
  ["{name} holds {n} points, at most {m} are read: thin the scan out, 2 cm between " +
      "points are enough"]:
    "{name} enthält {n} Punkte, höchstens {m} werden gelesen: den Scan ausdünnen, 2 cm " +
      "zwischen den Punkten genügen",
  "{name} has more than {n} MB; thin the scan out, 2 cm between points are enough":
    "{name} hat mehr als {n} MB; den Scan ausdünnen, 2 cm zwischen den Punkten genügen",
  "{name} holds neither points nor surfaces": "{name} enthält weder Punkte noch Flächen",
  "{name} covers {a} m^2; cut out the part to fly in":
    "{name} umfasst {a} m²; den Teil zum Fliegen ausschneiden",
  ["{n} boxes and more are needed, at most {m} are supported: cut out the part to fly " +
      "in, and clean it of single points"]:
    "{n} Quader und mehr wären nötig, höchstens {m} gehen: den Teil zum Fliegen " +
      "ausschneiden und von einzelnen Punkten säubern",
  "{name} cannot be read as SVG: {why}": "{name} kann nicht als SVG gelesen werden: {why}",
  "{name} cannot be read as DXF: {why}": "{name} kann nicht als DXF gelesen werden: {why}",
  "{name} cannot be read: {why}": "{name} kann nicht gelesen werden: {why}",
  "{name}: no room is read from such a file; allowed: {thing}":
    "{name}: aus so einer Datei wird kein Raum gelesen; erlaubt: {thing}",
  "{name} is no file; check its name": "{name} ist keine Datei; den Namen prüfen",
  ["{a} % of its {b} m^2 were never seen: unexplored, not flown over " +
      "(unexplored=free changes that)"]:
    "{a} % seiner {b} m² wurden nie gesehen: unerkundet, wird nicht überflogen (oben änderbar)",
  "unexplored floor counts as free, as you said":
    "unerkundeter Boden gilt als frei, wie angegeben",
  "the drone fits nowhere: {a} % of the floor were never seen":
    "die Drohne passt nirgends hin: {a} % des Bodens wurden nie gesehen",
  "{name} has the text {thing}, read as the number {n}":
    "{name} hat den Text {thing}, gelesen als Zahl {n}",
  "image is {thing}, which is not there: {name} beside the yaml was read":
    "image ist {thing}, das es nicht gibt: Gelesen wurde {name} neben der yaml-Datei",
  ["grey 205 counts as never seen, although free_thresh ({a}) calls it free: " +
      "map_saver writes it for that"]:
    "Grau 205 gilt als nie gesehen, obwohl free_thresh ({a}) es frei nennt: " +
      "map_saver schreibt es dafür",
  ["every line is taken for a wall: no layer is called so; say layers= if only " +
      "some hold them: {name}"]:
    "jede Linie gilt als Wand: Keine Ebene heißt so; die Ebenen angeben, wenn nur " +
      "manche Wände enthalten: {name}",
  "{name} and {n} more": "{name} und {n} weitere",
  ["its numbers ({a} x {b}) are {words}, a room of {c} m x {d} m: measure one " +
      "wall, and say the unit if it is not so long"]:
    "seine Zahlen ({a} x {b}) gelten als {words}, ein Raum von {c} m x {d} m: eine " +
      "Wand messen und die Einheit angeben, wenn sie nicht so lang ist",
  ["its numbers ({a} x {b}) cannot be {words}, and were {then}, a room of {c} m x " +
      "{d} m: measure one wall, and say the unit if it is not so long"]:
    "seine Zahlen ({a} x {b}) können nicht „{words}“ sein und gelten als {then}, " +
      "ein Raum von {c} m x {d} m: eine Wand messen und die Einheit angeben, wenn " +
      "sie nicht so lang ist",
  "inches, as the file writes its lengths": "Zoll, wie die Datei Längen schreibt",
  "{c} m each, as the file says": "je {c} m, wie die Datei sagt",
  "taken for {words}": "{words}",
  "drawn at 1:{n}": "Zeichnung 1:{n}",
  "feet": "Fuß",
  "its numbers ({thing}) are {a} m each, as the file says":
    "seine Zahlen ({thing}) sind laut Datei je {a} m",
  "left out: {n} of {m} points ({words})": "ausgelassen: {n} von {m} Punkten ({words})",
  "left out: {n} points that it calls noise": "ausgelassen: {n} Punkte, die sie Rauschen nennt",
  "left out: {n} parts that are neither points nor surfaces":
    "ausgelassen: {n} Teile, die weder Punkte noch Flächen sind",
  "no lines or shapes": "keine Linien oder Formen",
  "hidden, or on a layer that is frozen or off":
    "verborgen oder auf einer gefrorenen oder ausgeschalteten Ebene",
  "cannot be read": "nicht lesbar",
  "on layers without walls": "auf Ebenen ohne Wände",
  "2 cm and smaller": "2 cm und kleiner",
  "far away from all the rest": "weit weg von allem anderen",
  "no numbers": "keine Zahlen",
  "the file is damaged; faults in it that were mended or left out: {n}":
    "die Datei ist beschädigt; behobene oder ausgelassene Fehler: {n}",
  "the file ends in the middle: it was cut off":
    "die Datei endet mittendrin: Sie wurde abgeschnitten",
  "the file ends in the middle: {n} points are missing":
    "die Datei endet mittendrin: {n} Punkte fehlen",
  "its points are about {a} cm apart: cells of {b} cm":
    "ihre Punkte liegen etwa {a} cm auseinander: Zellen von {b} cm",
  ["{name} has points more than {a} cm apart, too few to tell walls from gaps: " +
      "export it denser, 2 cm between points are best, or as a mesh; or is its unit " +
      "another one?"]:
    "die Punkte von {name} liegen mehr als {a} cm auseinander, zu wenig, um Wände " +
      "von Lücken zu unterscheiden: dichter ausgeben, am besten alle 2 cm, oder als " +
      "Flächen; oder ist die Einheit eine andere?",
  "{name} points up, as the format has it": "{name} zeigt nach oben, wie das Format es hat",
  "{name} measures {thing}: all its points lie on one line or plane":
    "{name} misst {thing}: alle Punkte liegen auf einer Linie oder Ebene",
  "{name} stores its surfaces by {thing}, which is not read: export it without compression":
    "{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne Kompression ausgeben",
  ["{name} stores its surfaces by {thing}, which is not read: export it without " +
      "compression, or pip install DracoPy"]:
    "{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne " +
      "Kompression ausgeben oder pip install DracoPy",
  ["{name} stores its surfaces by {thing}, which is not read: export it without " +
      "compression or quantization"]:
    "{name} speichert Flächen mit {thing}, das nicht gelesen wird: ohne " +
      "Kompression und Quantisierung ausgeben",
  "{name} needs {thing}, which is not beside it: choose both files, or export it as one .glb":
    "{name} braucht {thing}, das nicht daneben liegt: beide Dateien wählen oder " +
      "als ein .glb ausgeben",
  "{name} holds no points, or none that is finite":
    "{name} enthält keine Punkte oder keine endlichen",
  "{name} has points without three coordinates each": "{name} hat Punkte ohne drei Koordinaten",
  "{name} ends in the middle: {a} of {b} bytes are there":
    "{name} endet mittendrin: {a} von {b} Bytes sind da",
  "{name} is damaged: its points are not as long as it says":
    "{name} ist beschädigt: Die Punkte sind nicht so lang wie angegeben",
  "{name} has no good header of a PCD: {why}":
    "{name} hat keinen guten Kopf einer PCD-Datei: {why}",
  "{name} has no field {thing}; it has: {place}": "{name} hat kein Feld {thing}; es hat: {place}",
  "{name} has more than {n} numbers a point": "{name} hat mehr als {n} Zahlen je Punkt",
  "{name} defines entities; save it as plain SVG":
    "{name} definiert Entitäten; als einfaches SVG speichern",
  "{name}: no room is read from such a file; {words}; allowed: {thing}":
    "{name}: Aus so einer Datei wird kein Raum gelesen; {words}; erlaubt: {thing}",
  "give the map's yaml file, which names the picture":
    "die yaml-Datei der Karte angeben, die das Bild nennt",
  "export the plan as .svg or .dxf": "den Grundriss als .svg oder .dxf ausgeben",
  "export the walls as .dxf": "die Wände als .dxf ausgeben",
  "export the scan as .glb or .ply": "den Scan als .glb oder .ply ausgeben",
  "export the scan as .ply or .e57": "den Scan als .ply oder .e57 ausgeben",
  "the floor was taken at {a} m in it": "der Boden liegt darin bei {a} m",
  // files of ROS maps, plans and scans, and values of them
  "0 or 1": "0 oder 1",
  "a list x, y, yaw of three numbers [m, m, rad]":
    "eine Liste x, y, yaw aus drei Zahlen [m, m, rad]",
  "a number from {a} to {b}": "eine Zahl von {a} bis {b}",
  "a number from {a} to {b} {unit}": "eine Zahl von {a} bis {b} {unit}",
  "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max":
    "ein Rechteck ist x_min, y_min, x_max, y_max [m] mit x_min < x_max und y_min < y_max",
  "as tracking sees them": "für die Ortung",
  "blocks are nested deeper than {n} levels": "Blöcke sind mehr als {n} Ebenen tief verschachtelt",
  "ceiling {c} m": "Decke {c} m",
  "ceiling {c} m (not in the scan: as usual)": "Decke {c} m (nicht im Scan: wie üblich)",
  "groups are nested deeper than {n} levels": "Gruppen sind mehr als {n} Ebenen tief verschachtelt",
  "input should be a valid boolean": "wahr oder falsch angeben",
  "input should be a valid integer": "eine ganze Zahl angeben",
  "input should be a valid integer, unable to parse string as an integer":
    "eine ganze Zahl angeben",
  "input should be a valid string": "einen Text angeben",
  "input should be a valid tuple": "eine Liste angeben",
  "input should be {names}": "erlaubt: {names}",
  "is not a known key: did you mean {names}?": "ist kein bekannter Schlüssel: Ist {names} gemeint?",
  "is the text {thing}": "ist der Text {thing}",
  "is {a}; allowed: {b} to {c} metres per unit of the file":
    "ist {a}; erlaubt: {b} bis {c} Meter je Einheit der Datei",
  "is {name}; allowed: a number from {a} to {b}": "ist {name}; erlaubt: eine Zahl von {a} bis {b}",
  "is {name}; allowed: a number from {a} to {b} {unit}":
    "ist {name}; erlaubt: eine Zahl von {a} bis {b} {unit}",
  "is {thing}": "ist {thing}",
  "its numbers ({a} x {b}) are {words}: measure one wall, and say the unit if it is not so long":
    "seine Zahlen ({a} x {b}) sind {words}: eine Wand messen und die Einheit angeben, " +
      "wenn sie nicht so lang ist",
  "its reader stops with {name}": "der Leser bricht mit {name} ab",
  "left out: {names} ({words})": "ausgelassen: {names} ({words})",
  "left over: {names}": "Rest: {names}",
  "m per pixel": "m je Bildpunkt",
  "missing required argument": "es fehlt",
  "more than {n} blocks are inserted; leave out what is no wall":
    "mehr als {n} Blöcke sind eingefügt; weglassen, was keine Wand ist",
  "more than {n} elements; leave out what is no wall":
    "mehr als {n} Elemente; weglassen, was keine Wand ist",
  "more than {n} shapes; leave out what is no wall":
    "mehr als {n} Formen; weglassen, was keine Wand ist",
  "on the map": "auf der Karte",
  "rect as large as the page": "rect so groß wie die Seite",
  "string should have at least {n} characters": "mindestens {n} Zeichen",
  "string should match pattern '{name}'": "es muss zu '{name}' passen",
  "the floor": "der Boden",
  "the map's picture {name} cannot be read: {why}; allowed: pgm or png":
    "das Bild der Karte {name} kann nicht gelesen werden: {why}; erlaubt: pgm oder png",
  "the name of a pgm or png file beside the yaml":
    "der Name einer pgm- oder png-Datei neben der yaml-Datei",
  ["the points are within {a} m of each other {what}; take points that are {b} m and " +
      "more apart, better several metres"]:
    "die Punkte liegen {what} innerhalb von {a} m; Punkte nehmen, die {b} m und mehr " +
      "auseinanderliegen, besser mehrere Meter",
  "the reader of scans ({name})": "das Leseprogramm für Scans ({name})",
  "the reader of {kind} ({name})": "das Leseprogramm für {kind} ({name})",
  "{a} x {b} x {c}": "{a} x {b} x {c}",
  "{kind} of {name}, which is not in it": "{kind} von {name}, das nicht darin ist",
  "{kind} should have at most {n} items after validation, not {m}":
    "höchstens {n} Einträge, nicht {m} ({kind})",
  "{names} (save the map again)": "{names} (die Karte neu speichern)",
  "{name} answers {n} times a second: {words}, battery {p} %, firmware {firmware}":
    "{name} antwortet {n}-mal je Sekunde: {words}, Akku {p} %, Firmware {firmware}",
  "{name} cannot be kept as .old: {why}": "{name} kann nicht als .old aufgehoben werden: {why}",
  "{name} cannot be read as a scan: {why}; is the file whole?":
    "{name} kann nicht als Scan gelesen werden: {why}; ist die Datei vollständig?",
  "{name} cannot be read: its reader broke; is the file whole?":
    "{name} kann nicht gelesen werden: das Leseprogramm brach ab; ist die Datei vollständig?",
  "{name} cannot be read: {why}; give the map's yaml file":
    "{name} kann nicht gelesen werden: {why}; die yaml-Datei der Karte angeben",
  "{name} cannot be read: {why}; mend it or move it away":
    "{name} kann nicht gelesen werden: {why}; die Datei berichtigen oder entfernen",
  "{name} cannot be written: {why}": "{name} kann nicht geschrieben werden: {why}",
  "{name} has decimals for pixels; save it as png or pgm with 8 bits each":
    "{name} hat Kommazahlen als Bildpunkte; als png oder pgm mit je 8 Bit speichern",
  "{name} has more than 16 bits a pixel; save it as png or pgm with 8":
    "{name} hat mehr als 16 Bit je Bildpunkt; als png oder pgm mit 8 speichern",
  "{name} has no good header of a LAS; is the file whole?":
    "{name} hat keinen guten Kopf einer LAS-Datei; ist die Datei vollständig?",
  "{name} has no good header of an E57; is the file whole?":
    "{name} hat keinen guten Kopf einer E57-Datei; ist die Datei vollständig?",
  "{name} is farther away than any room is long: {ask}":
    "{name} ist weiter weg, als ein Raum lang ist: {ask}",
  "{name} is no map's yaml: allowed are {n} characters, and {m} brackets":
    "{name} ist keine yaml-Datei einer Karte: erlaubt sind {n} Zeichen und {m} Klammern",
  "{name} is not a map's yaml file: it has no keys image, resolution, origin":
    "{name} ist keine yaml-Datei einer Karte: die Schlüssel image, resolution und origin fehlen",
  "{name} is not a yaml file: {why}": "{name} ist keine yaml-Datei: {why}",
  "{name} is {a} m by {b} m; allowed: up to {c} m along each side":
    "{name} hat {a} m mal {b} m; erlaubt: bis {c} m je Seite",
  "{name} is {n} x {m} pixels; at most {p} a side can be imported":
    "{name} hat {n} x {m} Bildpunkte; höchstens {p} je Seite können eingelesen werden",
  "{name} measures {a} x {b}: no room in any usual unit; say how many metres one unit is":
    "{name} misst {a} x {b}: in keiner üblichen Einheit ein Raum; angeben, wie viele " +
      "Meter eine Einheit ist",
  "{name} {n} cm": "{name} {n} cm",
  "{name}: free_thresh ({a}) must be below occupied_thresh ({b})":
    "{name}: free_thresh ({a}) muss unter occupied_thresh ({b}) liegen",
  "{name}: origin has yaw {a} rad; only 0 can be imported: turn the picture and set yaw to 0":
    "{name}: origin hat yaw {a} rad; nur 0 kann eingelesen werden: das Bild drehen und " +
      "yaw auf 0 setzen",
  "{name}: the map covers more than {a} m^2; cut out the part to fly in":
    "{name}: die Karte umfasst mehr als {a} m²; den Teil zum Fliegen ausschneiden",
  "{name}: the map has no free pixel; check negate (0 or 1) and free_thresh":
    "{name}: die Karte hat keinen freien Bildpunkt; negate (0 oder 1) und free_thresh prüfen",
  "{name}: {a} m x {b} m, {n} boxes from {m} points; {ceiling}":
    "{name}: {a} m x {b} m, {n} Quader aus {m} Punkten; {ceiling}",
  "{name}: {key} {found}; allowed: {words}": "{name}: {key} {found}; erlaubt: {words}",
  "{n} more": "{n} weitere",
  "{n} {name}": "{n} {name}",
  "{part} is missing; install it with: {name}": "{part} fehlt; zu installieren mit: {name}",
  "{words} {unit}": "{words} {unit}",
  // what tracking and drone say of themselves, as on the console
  "connected to {name}, but it is silent": "mit {name} verbunden, doch es kommt nichts",
  "connected to {name}, but nothing new arrives; is {what} live, not paused?":
    "mit {name} verbunden, doch es kommt nichts Neues; läuft {what}, ohne Pause?",
  "found in the air by a new driver: it only hovers and lands":
    "ein neuer Treiber fand sie in der Luft: sie schwebt nur und landet",
  "frames arrive from {name}, but their time stands still; is {what} paused?":
    "von {name} kommen Bilder, doch ihre Zeit steht; ist {what} angehalten?",
  "frames do not come from {name}; set tracking.address to {other}":
    "Daten kommen nicht von {name}; in tracking.address {other} eintragen",
  "is its unit millimetres? choose metres in the tracking software":
    "sind es Millimeter? In der Ortungssoftware Meter wählen",
  ["no drone answers at {name} within {n} s: is it switched on, and is your computer " +
      "in the drone's Wi-Fi?"]:
    "unter {name} antwortet nach {n} s keine Drohne: ist sie eingeschaltet und der " +
      "Rechner in ihrem WLAN?",
  "nobody answers at {name}; is {what} running, and does it stream?":
    "niemand antwortet unter {name}; läuft {what}, und sendet es?",
  "not connected to {name} yet": "noch nicht mit {name} verbunden",
  "nothing came from {name}": "von {name} kam nichts",
  "poses are refused, {pose}: {ask}": "Posen werden abgelehnt, {pose}: {ask}",
  "the connection to {name} was lost": "die Verbindung zu {name} ging verloren",
  "the drone has not confirmed its limits yet":
    "die Drohne hat ihre Grenzwerte noch nicht bestätigt",
  "the drone keeps {setting} = {kept} instead of {wanted}":
    "die Drohne behält {setting} = {kept} statt {wanted}",
  "the room's process does not answer (its log: room.log)":
    "der Prozess des Raums antwortet nicht (Protokoll: room.log)",
  "what answers at {name} does not speak {protocol} ({error})":
    "was unter {name} antwortet, spricht nicht {protocol} ({error})",
  "{name} sends more than {n} frames a second; the rest is dropped":
    "{name} sendet mehr als {n} Bilder je Sekunde; der Rest fällt weg",
  "{name} streams with y up; choose z up in the tracking software":
    "{name} sendet mit y nach oben; in der Ortungssoftware z nach oben wählen",
  "{name}: reading failed ({error})": "{name}: Lesen misslang ({error})",
  "{why}, {more}": "{why}, {more}",
  "{why}: {more}": "{why}: {more}",
  "{why}; {more}": "{why}; {more}",
  "the simulated room": "der simulierte Raum",
  "{p} % of the free floor cannot be reached from the pad":
    "{p} % des freien Bodens sind vom Landeplatz nicht erreichbar",
  "write the site first": "erst den Ort schreiben",
  "clear a way, or leave it so": "Weg frei machen oder so lassen",
};
