package org.starl.sim.view;

import java.awt.AWTError;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.Rectangle;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.concurrent.CountDownLatch;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.WindowConstants;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Theme;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;

/** The window that shows a run or a trace. */
public final class Window {

  private static final Dimension USUAL = new Dimension(1360, 900);
  private static final Dimension LEAST = new Dimension(900, 500);

  private final Content content;
  private final JFrame frame = new JFrame();
  private final Timer timer;
  private long lastNs = System.nanoTime();

  private Window(Session session, Runnable closed) {
    content = new Content(session, frame::dispose);
    timer = new Timer(1000 / session.settings().maxFps(), tick -> tick());
    frame.setTitle(session.title() + " - StarL");
    frame.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosed(WindowEvent event) {
            timer.stop();
            closed.run();
          }
        });
    frame.setContentPane(content.panel());
    frame.setJMenuBar(content.menus());
    frame.setFocusTraversalKeysEnabled(false);
    Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
    frame.setSize(Math.min(USUAL.width, screen.width), Math.min(USUAL.height, screen.height));
    frame.setMinimumSize(
        new Dimension(Math.min(LEAST.width, screen.width), Math.min(LEAST.height, screen.height)));
    frame.setLocationRelativeTo(null);
  }

  /** Whether this machine can show a window. */
  public static boolean isPossible() {
    try {
      return !GraphicsEnvironment.isHeadless()
          && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
    } catch (HeadlessException | AWTError e) {
      return false;
    }
  }

  /**
   * Shows a run until the window is closed.
   *
   * @param live the started run that fills {@code recording}; null for a trace
   * @param isDark whether the window starts with the dark theme
   * @throws InterruptedException if the calling thread is interrupted while it waits
   */
  public static void show(Recording recording, @Nullable LiveRun live, boolean isDark)
      throws InterruptedException {
    show(recording, live, isDark, Playback::play);
  }

  /** Shows a complete recording, paused at a time in ns, until the window is closed. */
  public static void showAt(Recording recording, long atNs) throws InterruptedException {
    show(recording, null, false, playback -> playback.seek(atNs));
  }

  private static void show(
      Recording recording, @Nullable LiveRun live, boolean isDark, Consumer<Playback> start)
      throws InterruptedException {
    CountDownLatch isClosed = new CountDownLatch(1);
    SwingUtilities.invokeLater(() ->
        whenBegun(
            recording,
            isClosed,
            () -> {
              Content.setLook(isDark);
              Session session = new Session(recording, live);
              session.view().paintIn(isDark ? Theme.DARK : Theme.LIGHT);
              start.accept(session.playback());
              new Window(session, isClosed::countDown).open();
            }));
    isClosed.await();
  }

  /** Waits for the header, which another thread provides; a run that fails at once has none. */
  private static void whenBegun(Recording recording, CountDownLatch isClosed, Runnable open) {
    Timer waiting = new Timer(10, null);
    waiting.addActionListener(tick -> {
      if (recording.hasBegun()) {
        waiting.stop();
        open.run();
      } else if (recording.isOver()) {
        waiting.stop();
        isClosed.countDown();
      }
    });
    waiting.start();
  }

  private void open() {
    frame.setVisible(true);
    content.floor().surface().requestFocusInWindow();
    lastNs = System.nanoTime();
    timer.start();
  }

  private void tick() {
    long nowNs = System.nanoTime();
    content.tick(nowNs, nowNs - lastNs);
    lastNs = nowNs;
  }
}
