// Whether this is a phone, upright or on its side: its stage is swiped, its lists are one sheet.
import { signal } from "@preact/signals";

const fits = matchMedia("(max-width: 599px), (max-height: 559px) and (min-aspect-ratio: 1/1)");

export const isPhone = signal(fits.matches);
fits.onchange = () => (isPhone.value = fits.matches);
