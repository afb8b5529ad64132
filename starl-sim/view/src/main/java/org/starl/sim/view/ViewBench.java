package org.starl.sim.view;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import org.starl.geometry.Obstacles;
import org.starl.sim.Simulation;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.LiveRun;
import org.starl.sim.replay.Recording;
import org.starl.time.Time;

/**
 * Measures the frame rate of the floor while the simulation runs on another thread. Paints in
 * memory as the window does, without a screen.
 *
 * @param frames number of painted frames
 * @param cpuMs CPU time of the painting thread per frame, with everything that the window does for
 *     it
 * @param longestMs longest time between two frames
 * @param wallS real time
 * @param simulatedS simulated time
 * @param events number of observed events
 */
public record ViewBench(
    int frames, double cpuMs, double longestMs, double wallS, double simulatedS, int events) {

  private static final int WIDTH_PX = 1280;
  private static final int HEIGHT_PX = 800;
  private static final int WARM_UP_FRAMES = 20;

  /**
   * Runs the measurement.
   *
   * @param speed wanted simulated seconds per real second; a slow machine reaches less
   * @param forS real time of the measurement
   */
  public static ViewBench take(Simulation.Builder simulation, double speed, double forS)
      throws InterruptedException {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
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
    FloorView floor = new FloorView(session);
    BufferedImage image = new BufferedImage(WIDTH_PX, HEIGHT_PX, BufferedImage.TYPE_INT_RGB);
    int frames = -WARM_UP_FRAMES;
    long fromNs = System.nanoTime();
    long lastNs = fromNs;
    long simulatedFromNs = 0;
    int eventsFrom = 0;
    long longestNs = 0;
    long cpuFromNs = 0;
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    while (frames < 0 || Time.seconds(lastNs - fromNs) < forS) {
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
        (threads.getCurrentThreadCpuTime() - cpuFromNs) / (double) Time.NS_PER_MS / frames,
        longestNs / (double) Time.NS_PER_MS,
        Time.seconds(lastNs - fromNs),
        Time.seconds(session.playback().nowNs() - simulatedFromNs),
        session.playback().index() - eventsFrom);
  }

  public double framesPerS() {
    return frames / wallS;
  }
}
