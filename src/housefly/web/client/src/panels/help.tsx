import { KEYS, letters, useLetters } from "../keymap";
import { panel } from "../store";

/** All keys. Not modal: STOP stays within reach. */
export function Help() {
  if (panel.value !== "help") return null;
  return (
    <section class="sheet" role="dialog" aria-label="Keys">
      <h2>Keys</h2>
      <table>
        <tbody>
          {KEYS.map((key) => (
            <tr key={key.shown}>
              <th scope="row">
                <kbd>{key.shown}</kbd>
              </th>
              <td>{key.does}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class="quiet">
        Space stops the drone even while you type, as long as it flies. On the ground it types a
        space, or presses the button that has the focus.
      </p>
      <label class="choice">
        <input
          type="checkbox"
          checked={letters.value}
          onChange={(event) => useLetters(event.currentTarget.checked)}
        />
        Letters and ? are keys
      </label>
      <button type="button" class="quiet-button" onClick={() => (panel.value = "")}>
        Close
      </button>
    </section>
  );
}
