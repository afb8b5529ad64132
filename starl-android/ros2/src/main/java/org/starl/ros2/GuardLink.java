package org.starl.ros2;

import static org.starl.time.Time.NS_PER_MS;

import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.concurrent.TimeUnit;
import org.starl.body.WheelCommand;
import org.starl.robot.create.WheelGuard;
import org.starl.robot.realtime.Daemons;
import org.starl.robot.realtime.RealClock;

/** The program's end of a guard's process. {@link #send} is for one thread at a time. */
final class GuardLink implements SpeedLink {

  /** A JVM with the DDS library starts within it, also on a busy small computer. */
  private static final long START_MS = 15_000;

  private static final long END_MS = 1000;

  private final Process process;
  private final DataOutputStream out;
  private final long openedNs = RealClock.machineNs();
  private volatile long heardNs = Long.MIN_VALUE;
  private volatile boolean isReceived;
  private volatile boolean isOver;

  GuardLink(String name, Process process) {
    this.process = process;
    out = new DataOutputStream(new java.io.BufferedOutputStream(process.getOutputStream()));
    Daemons.of(name + " ros2 guard", this::read).start();
  }

  @Override
  public void send(WheelCommand speeds) {
    try {
      out.writeLong(RealClock.machineNs());
      out.writeDouble(speeds.linearMmPerS());
      out.writeDouble(speeds.angularRadPerS());
      out.flush();
    } catch (IOException e) {
      isOver = true;
    }
  }

  @Override
  public boolean isReceived() {
    return isReceived && isAlive();
  }

  @Override
  public boolean isAlive() {
    long limitMs = heardNs == Long.MIN_VALUE ? START_MS : WheelGuard.SILENT_MS;
    long sinceNs = heardNs == Long.MIN_VALUE ? openedNs : heardNs;
    return !isOver && RealClock.machineNs() - sinceNs <= limitMs * NS_PER_MS;
  }

  @Override
  public void close() {
    try {
      OutputStream input = process.getOutputStream();
      input.close();
      if (isAlive() && process.waitFor(END_MS, TimeUnit.MILLISECONDS)) {
        return;
      }
    } catch (IOException e) {
      isOver = true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    process.destroyForcibly();
  }

  private void read() {
    try (InputStream in = process.getInputStream()) {
      for (int answer = in.read(); answer >= 0; answer = in.read()) {
        heardNs = RealClock.machineNs();
        isReceived = answer == 1;
      }
    } catch (IOException e) {
      isReceived = false;
    }
    isOver = true;
  }
}
