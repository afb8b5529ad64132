package org.starl.sim.view;

import java.awt.event.ActionEvent;
import java.util.Locale;
import java.util.Objects;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;

/** A command of the window, with a key; also for menus and buttons. */
// Never serialized: a window is not kept in files.
@SuppressWarnings("serial")
final class Command extends AbstractAction {

  private final Runnable action;
  private final String group;
  private final String keys;

  /**
   * @param group heading in the help sheet and title of the menu
   * @param name a few words
   * @param meaning one line, for a tooltip
   * @param key as {@link KeyStroke#getKeyStroke(String)} reads it
   */
  Command(String group, String name, String meaning, String key, Runnable action) {
    super(name);
    this.action = action;
    this.group = group;
    keys = key.equals("F1") ? "F1 or ?" : readable(key);
    putValue(SHORT_DESCRIPTION, meaning + " (" + keys + ")");
    putValue(ACCELERATOR_KEY, Objects.requireNonNull(KeyStroke.getKeyStroke(key), key));
  }

  /** {@code shift →} of {@code shift RIGHT}. */
  private static String readable(String key) {
    String modifier = key.substring(0, key.indexOf(' ') + 1);
    String last = key.substring(modifier.length());
    String shown =
        switch (last) {
          case "LEFT" -> "\u2190";
          case "UP" -> "\u2191";
          case "RIGHT" -> "\u2192";
          case "DOWN" -> "\u2193";
          case "COMMA" -> ",";
          case "PERIOD" -> ".";
          default -> last.length() == 1 ? last : last.toLowerCase(Locale.ROOT);
        };
    return modifier.equals("typed ") ? shown : modifier + shown;
  }

  String group() {
    return group;
  }

  String name() {
    return String.valueOf(getValue(Action.NAME));
  }

  /** The key in readable form. */
  String keys() {
    return keys;
  }

  KeyStroke stroke() {
    return (KeyStroke) getValue(ACCELERATOR_KEY);
  }

  void run() {
    action.run();
  }

  @Override
  public void actionPerformed(ActionEvent event) {
    run();
  }
}
