package org.starl.sim.view;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import org.jspecify.annotations.Nullable;

/** Something that a person may ask of the window, by key, button or menu. */
// Never serialized: a window is not kept in files.
@SuppressWarnings("serial")
final class Command extends AbstractAction {

  private final Runnable does;
  private final String group;
  private final String keys;

  /**
   * @param group under which the help sheet lists it
   * @param name a few words
   * @param meaning a line, for a tooltip
   * @param key as of {@link KeyStroke#getKeyStroke(String)}; empty for none
   * @param shown the key as people write it
   */
  Command(String group, String name, String meaning, String key, String shown, Runnable does) {
    super(name);
    this.does = does;
    this.group = group;
    keys = shown;
    putValue(SHORT_DESCRIPTION, shown.isEmpty() ? meaning : meaning + " (" + shown + ")");
    KeyStroke stroke = key.isEmpty() ? null : KeyStroke.getKeyStroke(key);
    if (!key.isEmpty() && stroke == null) {
      throw new IllegalArgumentException("key '" + key + "' of '" + name + "'");
    }
    putValue(ACCELERATOR_KEY, stroke);
  }

  String group() {
    return group;
  }

  String name() {
    return String.valueOf(getValue(Action.NAME));
  }

  /** The key as displayed; empty if there is none. */
  String keys() {
    return keys;
  }

  @Nullable KeyStroke stroke() {
    return (KeyStroke) getValue(ACCELERATOR_KEY);
  }

  void run() {
    does.run();
  }

  @Override
  public void actionPerformed(ActionEvent event) {
    run();
  }
}
