import"./chunk-chunk-6S6ESX7V.js";
