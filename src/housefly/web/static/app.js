import"./chunk-chunk-VGICRZLE.js";
