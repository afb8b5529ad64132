package org.starl.sim.view;

import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;

/**
 * The frame rate of the window's floor during a live simulation, painted as in the window but in
 * memory, without a screen.
 *
 * @param frames number of painted frames
 * @param cpuMs time of the painting thread per frame, including all other work of the window
 * @param longestMs longest time between two frames
 * @param wallS duration
 * @param simulatedS simulated time shown
 * @param events number of events of the trace, all of which were processed
 */
public record ViewBench(
    int frames, double cpuMs, double longestMs, double wallS, double simulatedS, int events) {

  private static final int WIDTH_PX = 1280;
  private static final int HEIGHT_PX = 800;
  private static final int WARM_UP_FRAMES = 20;
  private static final double NS_PER_S = 1e9;
  private static final double NS_PER_MS = 1e6;

  /** A layer without content, and so without state. */
  private static final class Plain implements Layer {
    @Override
    public Layer copy() {
      return this;
    }
  }

  /**
   * Measures, for so long.
   *
   * @param speed requested simulated seconds per real second; a slow machine reaches less
   */
  public static ViewBench take(Simulation.Builder simulation, double speed, double forS)
      throws InterruptedException {
    Recording recording = new Recording(Obstacles.NONE, new Plain());
    try (LiveRun live = new LiveRun(simulation, recording)) {
      live.runUntil(1);
      live.start();
      while (!recording.hasBegun() && !live.isOver()) {
        Thread.onSpinWait();
      }
      Session session = new Session(recording, live);
      session.playback().setSpeed(speed);
      session.playback().play();
      return measure(session, forS);
    }
  }

  private static ViewBench measure(Session session, double forS) {
    FloorView floor = new FloorView(session, new Nobody());
    BufferedImage image = new BufferedImage(WIDTH_PX, HEIGHT_PX, BufferedImage.TYPE_INT_RGB);
    int frames = -WARM_UP_FRAMES;
    long fromNs = System.nanoTime();
    long lastNs = fromNs;
    long simulatedFromNs = 0;
    int eventsFrom = 0;
    long longestNs = 0;
    long cpuFromNs = 0;
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    while (frames < 0 || lastNs - fromNs < forS * NS_PER_S) {
      long nowNs = System.nanoTime();
      if (frames == 0) {
        fromNs = nowNs;
        simulatedFromNs = session.playback().nowNs();
        eventsFrom = session.playback().index();
        longestNs = 0;
        cpuFromNs = threads.getCurrentThreadCpuTime();
      }
      session.tick(nowNs, nowNs - lastNs);
      longestNs = Math.max(longestNs, nowNs - lastNs);
      lastNs = nowNs;
      Graphics2D page = image.createGraphics();
      floor.render(page, WIDTH_PX, HEIGHT_PX);
      page.dispose();
      frames++;
    }
    return new ViewBench(
        frames,
        (threads.getCurrentThreadCpuTime() - cpuFromNs) / NS_PER_MS / frames,
        longestNs / NS_PER_MS,
        (lastNs - fromNs) / NS_PER_S,
        (session.playback().nowNs() - simulatedFromNs) / NS_PER_S,
        session.playback().index() - eventsFrom);
  }

  public double framesPerS() {
    return frames / wallS;
  }

  /** Clicks nowhere. */
  private static final class Nobody implements FloorView.Clicks {
    @Override
    public void menu(MouseEvent event) {
      throw new IllegalStateException("nobody clicks in a benchmark");
    }

    @Override
    public void point(Point place) {
      throw new IllegalStateException("nobody clicks in a benchmark");
    }

    @Override
    public void selected(@Nullable RobotId robot) {
      throw new IllegalStateException("nobody clicks in a benchmark");
    }
  }
}
