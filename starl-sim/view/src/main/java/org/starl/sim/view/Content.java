package org.starl.sim.view;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import javax.imageio.ImageIO;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.starl.sim.record.Theme;
import org.starl.time.Time;

/** The components of the window and its commands. Works without a screen. */
final class Content {

  private static final int SIDE_PX = 380;
  private static final long SHOWN_NS = 8 * Time.NS_PER_S;

  private final Session session;
  private final Runnable close;
  private final JPanel panel = new JPanel(new BorderLayout());
  private final Commands commands;
  private final JMenuBar menus;
  private final FloorView floor;
  private final TimelineView timeline;
  private final LanesView lanes;
  private final TransportBar transport;
  private final RobotList robots;
  private final SwitchView switches;
  private final InspectorView inspector;
  private final Interventions interventions;
  private final JLabel message = new JLabel(" ");
  private long shownForNs;

  /**
   * @param close closes the window
   */
  Content(Session session, Runnable close) {
    this.session = session;
    this.close = close;
    commands = new Commands(session, this);
    interventions = new Interventions(session, panel, this::report);
    floor = new FloorView(session);
    floor.listen(interventions);
    timeline = new TimelineView(session);
    lanes = new LanesView(session);
    transport = new TransportBar(session, commands);
    robots = new RobotList(session, session.view()::select);
    switches = new SwitchView(session);
    inspector = new InspectorView(session);
    JSplitPane middle = new JSplitPane(JSplitPane.VERTICAL_SPLIT, above(), lanes.pane());
    middle.setResizeWeight(1);
    middle.setBorder(BorderFactory.createEmptyBorder());
    panel.add(middle, BorderLayout.CENTER);
    panel.add(below(), BorderLayout.SOUTH);
    menus = menuBar();
    keys();
  }

  /** Sets the colours of all components. */
  static void setLook(boolean isDark) {
    if (isDark) {
      FlatDarkLaf.setup();
    } else {
      FlatLightLaf.setup();
    }
    UIManager.put("SplitPaneDivider.style", "plain");
    UIManager.put("ScrollBar.showButtons", false);
  }

  JPanel panel() {
    return panel;
  }

  JMenuBar menus() {
    return menus;
  }

  FloorView floor() {
    return floor;
  }

  Commands commands() {
    return commands;
  }

  private JComponent above() {
    JTabbedPane top = new JTabbedPane();
    top.setFocusable(false);
    top.addTab("Robots", null, robots.pane(), "All robots and their states");
    top.addTab("Layers", null, switches.pane(), "Show or hide parts of the picture");
    JSplitPane side = new JSplitPane(JSplitPane.VERTICAL_SPLIT, top, inspector.panel());
    top.setPreferredSize(new Dimension(SIDE_PX, 300));
    inspector.panel().setPreferredSize(new Dimension(SIDE_PX, 460));
    side.setResizeWeight(0.4);
    side.setBorder(BorderFactory.createEmptyBorder());
    side.setPreferredSize(new Dimension(SIDE_PX, 400));
    side.setMinimumSize(new Dimension(220, 200));
    floor.surface().setMinimumSize(new Dimension(160, 200));
    JSplitPane across = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, floor.surface(), side);
    across.setResizeWeight(1);
    across.setBorder(BorderFactory.createEmptyBorder());
    return across;
  }

  private JComponent below() {
    JPanel below = new JPanel(new BorderLayout());
    below.add(timeline.surface(), BorderLayout.NORTH);
    below.add(transport.panel(), BorderLayout.CENTER);
    message.setBorder(BorderFactory.createEmptyBorder(0, 16, 6, 16));
    message.setFont(message.getFont().deriveFont(Font.PLAIN));
    below.add(message, BorderLayout.SOUTH);
    return below;
  }

  private JMenuBar menuBar() {
    JMenuBar bar = new JMenuBar();
    for (String group : Commands.groups()) {
      JMenu menu = new JMenu(group);
      for (Command command : commands.of(group)) {
        menu.add(command).setToolTipText(null);
      }
      bar.add(menu);
    }
    return bar;
  }

  /** Binds the second key of the help command; the menus bind all others. */
  private void keys() {
    panel
        .getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
        .put(KeyStroke.getKeyStroke('?'), commands.help.name());
    panel.getActionMap().put(commands.help.name(), commands.help);
  }

  /**
   * Advances by real time.
   *
   * @param realNs time of a monotonic clock
   */
  void tick(long realNs, long elapsedNs) {
    session.tick(realNs, elapsedNs);
    shownForNs += elapsedNs;
    if (shownForNs > SHOWN_NS) {
      message.setText(" ");
    }
    read();
  }

  /** Updates all components. */
  void read() {
    floor.surface().repaint();
    timeline.surface().repaint();
    lanes.read();
    transport.read();
    robots.read();
    switches.read();
    inspector.read();
  }

  private void report(String line) {
    message.setText(line);
    shownForNs = 0;
  }

  void askPoint() {
    interventions.askPoint();
  }

  void askFault() {
    interventions.askFault();
  }

  void turnInspector() {
    inspector.turn();
  }

  void switchTheme() {
    boolean isDark = !session.view().look().theme().isDark();
    session.view().paintIn(isDark ? Theme.DARK : Theme.LIGHT);
    setLook(isDark);
    FlatLaf.updateUI();
  }

  void savePicture() {
    session.playback().pause();
    JFileChooser chooser = new JFileChooser(new File("."));
    String name = session.recording().header().scenario().replaceAll("[^A-Za-z0-9]+", "-");
    chooser.setSelectedFile(new File(name + ".png"));
    if (chooser.showSaveDialog(panel) == JFileChooser.APPROVE_OPTION) {
      save(chooser.getSelectedFile());
    }
  }

  void showHelp() {
    HelpSheet.show(panel, commands);
  }

  void close() {
    close.run();
  }

  /** Saves the floor with twice the resolution of the screen, for print. */
  private void save(File file) {
    int width = floor.surface().getWidth();
    int height = floor.surface().getHeight();
    BufferedImage image = new BufferedImage(2 * width, 2 * height, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.scale(2, 2);
    floor.render(page, width, height);
    page.dispose();
    try {
      boolean isWritten = ImageIO.write(image, "png", file);
      report(isWritten ? "Saved " + file : file + ": the picture cannot be saved as PNG");
    } catch (IOException e) {
      report(file + ": " + e.getMessage());
    }
  }
}
