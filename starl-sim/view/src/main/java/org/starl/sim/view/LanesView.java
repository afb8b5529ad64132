package org.starl.sim.view;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import javax.swing.JScrollPane;
import org.starl.sim.Failure;
import org.starl.sim.record.LanePainter;
import org.starl.sim.record.Lanes;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Theme;
import org.starl.sim.replay.Recording;

/** The lanes of all robots below the floor: a click goes to a moment. */
final class LanesView {

  private static final int SHOWN_PX = 150;

  /** For the colours of states, below the lanes. */
  private static final int KEY_PX = 60;

  /** Greatest number of events between two pictures. */
  private static final int EVENTS_A_PICTURE = 20_000;

  private final Session session;
  private final Lanes lanes = new Lanes();
  private final Surface surface;
  private final JScrollPane pane;
  private LanePainter painter = new LanePainter(lanes, 0, 1, 1);
  private int seen;

  // Painting takes long with many changes: it is done again when one of these has changed.
  private BufferedImage buffer = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
  private int paintedEvents = -1;
  private Theme paintedTheme = Theme.LIGHT;

  LanesView(Session session) {
    this.session = session;
    surface = new Surface(this::paint, event -> Inspection.seconds(painter.timeNs(event.getX())));
    surface.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            session.playback().pause();
            session.playback().seek(painter.timeNs(event.getX()));
          }
        });
    pane = new JScrollPane(surface);
    pane.setPreferredSize(new Dimension(400, SHOWN_PX));
    pane.getVerticalScrollBar().setUnitIncrement(15);
  }

  JScrollPane pane() {
    return pane;
  }

  /** Adds the events since the last call. */
  void read() {
    Recording recording = session.recording();
    int end = Math.min(recording.size(), seen + EVENTS_A_PICTURE);
    while (seen < end) {
      lanes.observe(recording.event(seen));
      seen++;
    }
    int heightPx = painter.heightPx() + KEY_PX;
    if (surface.getPreferredSize().height != heightPx) {
      surface.high(heightPx);
      surface.revalidate();
    }
    surface.repaint();
  }

  private void paint(Graphics2D page, int widthPx, int heightPx) {
    Theme theme = session.view().look().theme();
    if (buffer.getWidth() != widthPx
        || buffer.getHeight() != heightPx
        || paintedEvents != seen
        || !paintedTheme.equals(theme)) {
      painter = new LanePainter(lanes, 0, session.recording().endNs(), widthPx);
      buffer = new BufferedImage(widthPx, heightPx, BufferedImage.TYPE_INT_RGB);
      Graphics2D lanesPage = buffer.createGraphics();
      Painter.smooth(lanesPage);
      lanesPage.setColor(theme.paper());
      lanesPage.fillRect(0, 0, widthPx, heightPx);
      painter.paint(lanesPage, theme);
      lanesPage.dispose();
      paintedEvents = seen;
      paintedTheme = theme;
    }
    page.drawImage(buffer, 0, 0, null);
    Failure failure = session.recording().wentWrong();
    if (failure != null) {
      line(page, failure.atNs(), theme.alarm(), heightPx);
    }
    line(page, session.playback().nowNs(), Tones.accent(), heightPx);
  }

  private void line(Graphics2D page, long timeNs, Color colour, int heightPx) {
    page.setColor(colour);
    page.draw(new Line2D.Double(painter.xPx(timeNs), 0, painter.xPx(timeNs), heightPx));
  }
}
