package org.starl.sim.view;

import java.awt.Component;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.DefaultComboBoxModel;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.starl.sim.record.Part;

/** Check boxes for the parts of the picture and of the app's drawing, and a filter of messages. */
final class SwitchView {

  private static final String ALL = "all channels";

  private final Session session;
  private final JPanel panel = new JPanel();
  private final JScrollPane pane = new JScrollPane(panel);
  private final JComboBox<String> channels = new JComboBox<>(new String[] {ALL});
  private final List<Runnable> readers = new ArrayList<>();
  private boolean isReading;

  SwitchView(Session session) {
    this.session = session;
    panel.setLayout(new BoxLayout(panel, BoxLayout.Y_AXIS));
    panel.setBorder(BorderFactory.createEmptyBorder(10, 12, 10, 12));
    ViewState view = session.view();
    title("Picture");
    for (Part part : Part.values()) {
      String key = " (" + Commands.key(part) + ")";
      add(
          part.title(),
          "Show " + part.meaning() + key,
          () -> view.shows(part),
          isOn -> view.show(part, isOn));
    }
    List<String> parts = session.playback().layer().parts();
    if (!parts.isEmpty()) {
      title("App");
      for (int i = 0; i < parts.size(); i++) {
        String part = parts.get(i);
        add(
            part.substring(0, 1).toUpperCase(Locale.ROOT) + part.substring(1),
            "Show the app's " + part + " (control " + (i + 1) + ")",
            () -> view.look().shows(part),
            isOn -> view.show(part, isOn));
      }
    }
    title("Messages");
    channels.setFocusable(false);
    channels.setAlignmentX(0);
    channels.setMaximumSize(channels.getPreferredSize());
    channels.setToolTipText("Show only messages of one channel: a primitive and its instance");
    channels.addActionListener(event -> {
      Object channel = channels.getSelectedItem();
      if (!isReading && channel != null) {
        session.traffic().only(channel.equals(ALL) ? "" : channel.toString());
      }
    });
    panel.add(channels);
    add(
        "Only of the selected robot",
        "Hide messages between other robots (O)",
        session.traffic()::isOfSelectedOnly,
        session.traffic()::onlyOfSelected);
    pane.setBorder(BorderFactory.createEmptyBorder());
    pane.getVerticalScrollBar().setUnitIncrement(16);
  }

  JScrollPane pane() {
    return pane;
  }

  private void title(String text) {
    JLabel label = new JLabel(text);
    label.setFont(label.getFont().deriveFont(Font.BOLD));
    label.setAlignmentX(0);
    if (panel.getComponentCount() > 0) {
      panel.add(Box.createVerticalStrut(12));
    }
    panel.add(label);
    panel.add(Box.createVerticalStrut(4));
  }

  private void add(String text, String tip, BooleanSupplier state, Consumer<Boolean> change) {
    JCheckBox box = new JCheckBox(text);
    box.setToolTipText(tip);
    box.setFocusable(false);
    box.setAlignmentX(Component.LEFT_ALIGNMENT);
    box.addActionListener(clicked -> change.accept(box.isSelected()));
    readers.add(() -> box.setSelected(state.getAsBoolean()));
    panel.add(box);
  }

  /** Updates the check boxes, which keys change too. */
  void read() {
    readers.forEach(Runnable::run);
    if (channels.getItemCount() != session.traffic().channels().size() + 1) {
      isReading = true;
      DefaultComboBoxModel<String> model = new DefaultComboBoxModel<>();
      model.addElement(ALL);
      session.traffic().channels().forEach(model::addElement);
      String channel = session.traffic().channel();
      model.setSelectedItem(channel.isEmpty() ? ALL : channel);
      channels.setModel(model);
      channels.setMaximumSize(channels.getPreferredSize());
      isReading = false;
    }
  }
}
