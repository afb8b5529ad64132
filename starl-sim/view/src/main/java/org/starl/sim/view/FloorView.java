package org.starl.sim.view;

import java.awt.AlphaComposite;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Cursor;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Line2D;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.Failure;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Theme;
import org.starl.sim.record.Viewport;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;

/** The floor: dragging pans, the wheel zooms, a click selects a robot. */
final class FloorView {

  private static final double WHEEL = 1.15;
  private static final int MARGIN_PX = 12;
  private static final double BAR_PX = 110;
  private static final double[] BAR_MM = {
    10, 20, 50, 100, 200, 500, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5
  };

  private final Session session;
  private final Painter painter = new Painter();
  private final Surface surface;
  private BufferedImage buffer = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);

  FloorView(Session session) {
    this.session = session;
    surface = new Surface(this::paint, this::tip);
    surface.setFocusable(true);
    surface.setFocusTraversalKeysEnabled(false);
  }

  /** Handles the mouse from now on. */
  void listen(Interventions interventions) {
    Mouse mouse = new Mouse(interventions);
    surface.addMouseListener(mouse);
    surface.addMouseMotionListener(mouse);
    surface.addMouseWheelListener(mouse);
  }

  Surface surface() {
    return surface;
  }

  private void paint(Graphics2D page, int widthPx, int heightPx) {
    // Painting in memory is fast on every screen.
    double scale = page.getTransform().getScaleX();
    int wide = (int) Math.ceil(widthPx * scale);
    int high = (int) Math.ceil(heightPx * scale);
    if (buffer.getWidth() != wide || buffer.getHeight() != high) {
      buffer = new BufferedImage(Math.max(1, wide), Math.max(1, high), BufferedImage.TYPE_INT_RGB);
    }
    Graphics2D floor = buffer.createGraphics();
    floor.scale(scale, scale);
    render(floor, widthPx, heightPx);
    floor.dispose();
    Graphics2D device = (Graphics2D) page.create();
    device.drawImage(buffer, 0, 0, widthPx, heightPx, null);
    device.dispose();
  }

  /** Paints the floor with scale bar and banner. */
  void render(Graphics2D floor, int widthPx, int heightPx) {
    ViewState view = session.view();
    view.arrange(session.scene(), session.playback().layer(), widthPx, heightPx);
    painter.paint(
        floor,
        session.scene(),
        session.playback().layer(),
        view.viewport(),
        view.look(),
        session.flights());

    scaleBar(floor, view.viewport(), view.look().theme());
    banner(floor, widthPx, heightPx);
  }

  private static void scaleBar(Graphics2D page, Viewport viewport, Theme theme) {
    double best = BAR_MM[0];
    for (double mm : BAR_MM) {
      if (mm * viewport.pxPerMm() <= BAR_PX) {
        best = mm;
      }
    }
    double lengthPx = best * viewport.pxPerMm();
    double x = MARGIN_PX;
    double y = viewport.heightPx() - MARGIN_PX;
    page.setColor(theme.muted());
    page.setStroke(new BasicStroke(1.5f));
    page.draw(new Line2D.Double(x, y, x + lengthPx, y));
    page.draw(new Line2D.Double(x, y - 4, x, y));
    page.draw(new Line2D.Double(x + lengthPx, y - 4, x + lengthPx, y));
    page.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 11));
    String text = best >= 1000 ? (int) (best / 1000) + " m" : (int) best + " mm";
    page.drawString(text, (float) x + 4, (float) y - 5);
  }

  /** Shows an error, a violation, or the end of the run. */
  private void banner(Graphics2D page, int widthPx, int heightPx) {
    Theme theme = session.view().look().theme();
    Mark violation = session.violation();
    String failure = session.recording().failure();
    if (!failure.isEmpty()) {
      strip(page, widthPx, MARGIN_PX, failure, theme.alarm());
    } else if (session.recording().size() == 0) {
      strip(page, widthPx, heightPx / 2, "No events yet", theme.muted());
    } else if (violation != null) {
      strip(page, widthPx, MARGIN_PX, violation.text(), theme.alarm());
    } else if (session.playback().isAtEnd()) {
      Color colour = session.recording().wentWrong() == null ? theme.muted() : theme.alarm();
      strip(page, widthPx, MARGIN_PX, ending(session.recording()), colour);
    }
  }

  static String ending(Recording recording) {
    Failure failure = recording.wentWrong();
    String why =
        failure != null && failure.kind() == Failure.Kind.UNFINISHED
            ? "not finished: " + failure.cause()
            : "";
    String open = recording.isChecked() ? "" : "; specifications are still being checked";
    return "The run ended at "
        + Inspection.seconds(recording.endNs())
        + (why.isEmpty() ? "" : ", " + why)
        + open;
  }

  private static void strip(Graphics2D page, int widthPx, int topPx, String text, Color colour) {
    page.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 12));
    FontMetrics metrics = page.getFontMetrics();
    int most = widthPx - 2 * MARGIN_PX - 24;
    String shown = text;
    while (shown.length() > 4 && metrics.stringWidth(shown) > most) {
      shown = shown.substring(0, shown.length() - 4) + "\u2026";
    }
    int width = metrics.stringWidth(shown) + 24;
    double left = (widthPx - width) / 2.0;
    page.setComposite(AlphaComposite.getInstance(AlphaComposite.SRC_OVER, 0.92f));
    page.setColor(colour);
    page.fill(new RoundRectangle2D.Double(left, topPx, width, 26, 13, 13));
    page.setComposite(AlphaComposite.SrcOver);
    page.setColor(Theme.textOn(colour));
    page.drawString(shown, (float) left + 12, topPx + 17.5f);
  }

  private @Nullable String tip(MouseEvent event) {
    RobotId robot = session.view().robotAt(session.scene(), event.getX(), event.getY());
    if (robot == null) {
      return null;
    }
    String what = session.playback().layer().describe(robot, session.scene());
    return what.isBlank() ? robot.name() : robot + ": " + what.replace("\n", "; ");
  }

  private final class Mouse extends MouseAdapter {
    private final Interventions interventions;
    private int x;
    private int y;
    private boolean isDragged;

    Mouse(Interventions interventions) {
      this.interventions = interventions;
    }

    @Override
    public void mousePressed(MouseEvent event) {
      surface.requestFocusInWindow();
      x = event.getX();
      y = event.getY();
      isDragged = false;
    }

    @Override
    public void mouseDragged(MouseEvent event) {
      boolean isFar = Math.abs(event.getX() - x) + Math.abs(event.getY() - y) > 3;
      if (SwingUtilities.isLeftMouseButton(event) && (isDragged || isFar)) {
        isDragged = true;
        surface.setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
        session.view().pan(event.getX() - x, event.getY() - y);
        x = event.getX();
        y = event.getY();
        surface.repaint();
      }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      surface.setCursor(Cursor.getDefaultCursor());
      if (isDragged) {
        return;
      }
      ViewState view = session.view();
      RobotId robot = view.robotAt(session.scene(), event.getX(), event.getY());
      Point place = view.viewport().toWorld(event.getX(), event.getY());
      boolean isLeft = SwingUtilities.isLeftMouseButton(event);
      if (isLeft && event.isShiftDown()) {
        interventions.sendSelected(place);
      } else if (isLeft && !event.isControlDown()) {
        view.select(robot);
      } else {
        interventions.menu(robot, place).show(surface, event.getX(), event.getY());
      }
    }

    @Override
    public void mouseWheelMoved(MouseWheelEvent event) {
      double factor = StrictMath.pow(WHEEL, -event.getPreciseWheelRotation());
      session.view().zoom(factor, event.getX(), event.getY());
      surface.repaint();
    }
  }
}
