package org.starl.sim.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.List;
import java.util.Locale;
import javax.swing.UIManager;
import org.jspecify.annotations.Nullable;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Theme;
import org.starl.sim.replay.Mark;
import org.starl.time.Time;

/** The timeline: dragging seeks, a click on a mark goes to it. */
final class TimelineView {

  private static final int HEIGHT_PX = 52;
  private static final int SIDE_PX = 16;
  private static final int TRACK_PX = 22;
  private static final int NEAR_PX = 6;
  private static final double LEAST_TICK_PX = 80;
  private static final double[] TICKS_S = {
    0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1800, 3600, 7200
  };

  private final Session session;
  private final Surface surface;
  private double hoverPx = -1;

  TimelineView(Session session) {
    this.session = session;
    surface = new Surface(this::paint, this::tip).high(HEIGHT_PX);
    Mouse mouse = new Mouse();
    surface.addMouseListener(mouse);
    surface.addMouseMotionListener(mouse);
  }

  Surface surface() {
    return surface;
  }

  /** The displayed time span; for a live run longer than the run, so that it rarely changes. */
  private long spanNs() {
    long endNs = session.recording().endNs();
    if (session.recording().isOver()) {
      return Math.max(Time.NS_PER_S / 10, endNs);
    }
    long span = 20 * Time.NS_PER_S;
    while (span < endNs + endNs / 20) {
      span += span / 2;
    }
    return span;
  }

  private double xPx(long timeNs) {
    return SIDE_PX + (surface.getWidth() - 2.0 * SIDE_PX) * timeNs / spanNs();
  }

  private long timeNs(double xPx) {
    double share = (xPx - SIDE_PX) / Math.max(1, surface.getWidth() - 2.0 * SIDE_PX);
    return (long) (Math.max(0, Math.min(1, share)) * spanNs());
  }

  private void paint(Graphics2D page, int widthPx, int heightPx) {
    page.setColor(UIManager.getColor("Panel.background"));
    page.fillRect(0, 0, widthPx, heightPx);
    Theme theme = session.view().look().theme();
    ticks(page, theme);
    double nowPx = xPx(session.playback().nowNs());
    page.setColor(theme.floor());
    page.fill(new RoundRectangle2D.Double(SIDE_PX, TRACK_PX - 3, widthPx - 2.0 * SIDE_PX, 6, 6, 6));
    Color accent = Tones.accent();
    double recordedPx = xPx(session.recording().endNs());
    page.setColor(theme.isDark() ? theme.border() : theme.border().brighter());
    page.fill(new RoundRectangle2D.Double(SIDE_PX, TRACK_PX - 3, recordedPx - SIDE_PX, 6, 6, 6));
    page.setColor(accent);
    page.fill(new RoundRectangle2D.Double(SIDE_PX, TRACK_PX - 3, nowPx - SIDE_PX, 6, 6, 6));
    if (hoverPx >= SIDE_PX && hoverPx <= widthPx - SIDE_PX) {
      page.setColor(theme.muted());
      page.setStroke(new BasicStroke(1));
      page.draw(new Line2D.Double(hoverPx, TRACK_PX - 8, hoverPx, TRACK_PX + 8));
    }
    marks(page, theme);
    page.setColor(UIManager.getColor("Panel.background"));
    page.fill(new Ellipse2D.Double(nowPx - 8, TRACK_PX - 8, 16, 16));
    page.setColor(accent);
    page.fill(new Ellipse2D.Double(nowPx - 6, TRACK_PX - 6, 12, 12));
  }

  private void ticks(Graphics2D page, Theme theme) {
    double pxPerS = (surface.getWidth() - 2.0 * SIDE_PX) * Time.NS_PER_S / spanNs();
    double stepS = TICKS_S[TICKS_S.length - 1];
    for (int i = TICKS_S.length - 1; i >= 0; i--) {
      stepS = TICKS_S[i] * pxPerS >= LEAST_TICK_PX ? TICKS_S[i] : stepS;
    }
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 10));
    page.setColor(theme.muted());
    page.setStroke(new BasicStroke(1));
    for (int i = 0; i * stepS * Time.NS_PER_S <= spanNs() && i < 1000; i++) {
      double x = xPx((long) (i * stepS * Time.NS_PER_S));
      page.draw(new Line2D.Double(x, TRACK_PX + 9, x, TRACK_PX + 13));
      String text = label(i * stepS);
      int width = page.getFontMetrics().stringWidth(text);
      double left = Math.max(2, Math.min(x - width / 2.0, surface.getWidth() - width - 2.0));
      page.drawString(text, (float) left, TRACK_PX + 25);
    }
  }

  private static String label(double seconds) {
    if (seconds >= 60) {
      long whole = Math.round(seconds);
      return String.format(Locale.ROOT, "%d:%02d min", whole / 60, whole % 60);
    }
    String text = String.format(Locale.ROOT, "%.2f", seconds);
    return text.replaceAll("\\.?0+$", "") + " s";
  }

  private void marks(Graphics2D page, Theme theme) {
    List<Mark> marks = session.recording().marks();
    double[] lastPx = new double[Mark.Kind.values().length];
    for (Mark mark : marks) {
      double x = xPx(mark.timeNs());
      int kind = mark.kind().ordinal();
      // Marks of one kind in the same place are painted once.
      if (mark.kind() == Mark.Kind.VIOLATION || lastPx[kind] == 0 || x - lastPx[kind] >= 2) {
        paintMark(page, mark.kind(), x, theme);
        lastPx[kind] = x;
      }
    }
  }

  private static void paintMark(Graphics2D page, Mark.Kind kind, double x, Theme theme) {
    page.setStroke(new BasicStroke(2, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    page.setColor(colour(kind, theme));
    switch (kind) {
      case VIOLATION -> {
        page.draw(new Line2D.Double(x, TRACK_PX - 12, x, TRACK_PX + 6));
        Path2D flag = Figures.polygon(x, TRACK_PX - 17, x + 10, TRACK_PX - 12.5, x, TRACK_PX - 8);
        page.fill(flag);
        page.draw(flag);
      }
      case CRASH -> Painter.cross(page, x, TRACK_PX - 12, 3.5);
      case RESTART -> page.draw(new Ellipse2D.Double(x - 3.5, TRACK_PX - 15.5, 7, 7));
      case FAULT -> page.draw(new Line2D.Double(x, TRACK_PX - 14, x, TRACK_PX - 9));
      case INTERVENTION -> {
        // On the track: the mark of an injected fault is above.
        int y = TRACK_PX;
        Path2D diamond = Figures.polygon(x, y - 6.5, x + 6.5, y, x, y + 6.5, x - 6.5, y);
        page.fill(diamond);
        page.setColor(UIManager.getColor("Panel.background"));
        page.setStroke(new BasicStroke(1.5f));
        page.draw(diamond);
      }
    }
  }

  private static Color colour(Mark.Kind kind, Theme theme) {
    return switch (kind) {
      case VIOLATION -> theme.alarm();
      case CRASH, RESTART -> theme.ink();
      case FAULT -> theme.isDark() ? theme.gold() : theme.gold().darker();
      case INTERVENTION -> Tones.accent();
    };
  }

  private @Nullable Mark markAt(MouseEvent event) {
    Mark best = null;
    double bestPx = NEAR_PX;
    for (Mark mark : session.recording().marks()) {
      double px = Math.abs(xPx(mark.timeNs()) - event.getX());
      boolean isFirst = mark.kind() == Mark.Kind.VIOLATION && best != null && px <= NEAR_PX / 2.0;
      if (px < bestPx || isFirst) {
        best = mark;
        bestPx = px;
      }
    }
    return event.getY() < TRACK_PX - 4 ? best : null;
  }

  private String tip(MouseEvent event) {
    Mark mark = markAt(event);
    return mark == null
        ? Inspection.seconds(timeNs(event.getX()))
        : Inspection.seconds(mark.timeNs()) + ": " + mark.text();
  }

  private final class Mouse extends MouseAdapter {
    private boolean wasPlaying;

    @Override
    public void mousePressed(MouseEvent event) {
      wasPlaying = session.playback().isPlaying();
      session.playback().pause();
      Mark mark = markAt(event);
      if (mark != null) {
        wasPlaying = false;
        session.playback().toMark(mark);
      } else {
        session.playback().seek(timeNs(event.getX()));
      }
      surface.repaint();
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      hoverPx = event.getX();
      session.playback().seek(timeNs(event.getX()));
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      if (wasPlaying && !session.playback().isAtEnd()) {
        session.playback().play();
      }
    }

    @Override
    public void mouseMoved(MouseEvent event) {
      hoverPx = event.getX();
      surface.repaint();
    }

    @Override
    public void mouseExited(MouseEvent event) {
      hoverPx = -1;
      surface.repaint();
    }
  }
}
