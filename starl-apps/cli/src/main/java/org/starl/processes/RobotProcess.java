package org.starl.processes;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.robot.realtime.RealClock;
import org.starl.robot.trace.Outbox;
import org.starl.robot.trace.Word;
import org.starl.sim.Blueprint;
import org.starl.sim.RobotSpec;

/**
 * A whole process that is one robot: obeys its parent's orders until they end. Its app runs as often
 * as it was told to, each time as a new start of the program (another incarnation) over the same
 * stable storage; after the last one it goes on answering messages.
 */
public final class RobotProcess implements Incarnation.Host {

  private final Supplier<Blueprint> blueprints;
  private final RobotId self;
  private final Path folder;
  private final int rounds;
  private final Outbox outbox;
  private final BlockingQueue<Order> orders = new LinkedBlockingQueue<>();
  private final Map<RobotId, Integer> ports = new TreeMap<>();
  private volatile RealClock clock = new RealClock();
  private @Nullable Incarnation robot;
  private int started;

  private RobotProcess(
      Supplier<Blueprint> blueprints, RobotId self, Path folder, int rounds, OutputStream out) {
    this.blueprints = blueprints;
    this.self = self;
    this.folder = folder;
    this.rounds = rounds;
    outbox = new Outbox(self, blueprints.get().header(), out);
  }

  /**
   * Runs until {@code in} ends. A bug of the robot's program ends the whole process, with status 1.
   *
   * @param blueprints makes equal ones, one for each round: a director serves once
   * @param folder for stable storage, this robot's alone
   * @param rounds how often the app runs, from 1
   * @param in orders
   * @param out takes the trace
   * @throws IOException if radio or storage are not to be had
   */
  public static void run(
      Supplier<Blueprint> blueprints,
      RobotId self,
      Path folder,
      int rounds,
      InputStream in,
      OutputStream out)
      throws IOException {
    RobotProcess process = new RobotProcess(blueprints, self, folder, rounds, out);
    Thread reader = new Thread(() -> process.read(in), self + " orders");
    reader.setDaemon(true);
    reader.start();
    process.obey();
  }

  private void read(InputStream in) {
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        orders.add(Order.parse(line));
      }
    } catch (IOException e) {
      outbox.say(clock, Word.LOG, "WARN", "orders", e);
    } finally {
      orders.add(new Order.End());
    }
  }

  private void obey() throws IOException {
    outbox.say(clock, Word.HELLO, ProcessHandle.current().pid());
    boolean isOver = false;
    while (!isOver) {
      switch (next()) {
        case Order.Begin begin -> {
          clock = new RealClock(begin.originNs());
          outbox.say(clock, Word.PORT, bringUp(0).port());
        }
        case Order.Peer peer -> {
          ports.put(peer.robot(), peer.port());
          here().setPeer(peer.robot(), peer.port());
        }
        case Order.Go go -> here().start();
        case Order.Place place -> here().place();
        case Order.Finished end -> {
          if (started < rounds) {
            Incarnation before = here();
            int port = before.port();
            before.leave();
            Incarnation again = bringUp(port);
            ports.forEach(again::setPeer);
            again.start();
          }
        }
        case Order.End end -> isOver = true;
      }
    }
    if (robot != null) {
      robot.close();
    }
    outbox.end(clock.nowNs());
  }

  private Order next() {
    try {
      return orders.take();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Order.End();
    }
  }

  private Incarnation here() {
    if (robot == null) {
      throw new IllegalStateException(self + " has not begun");
    }
    return robot;
  }

  private Incarnation bringUp(int port) throws IOException {
    started++;
    Blueprint blueprint = blueprints.get();
    RobotSpec spec =
        blueprint.robots().stream()
            .filter(each -> each.id().equals(self))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException("there is no robot " + self));
    robot = new Incarnation(blueprint, spec, started, clock, folder, port, outbox, this);
    return robot;
  }

  @Override
  public void finished() {
    orders.add(new Order.Finished());
  }

  @Override
  public void failed(Throwable error) {
    StringBuilder text = new StringBuilder();
    for (Throwable cause = error; cause != null; cause = cause.getCause()) {
      text.append(cause).append('\n');
      for (StackTraceElement frame : cause.getStackTrace()) {
        text.append("    at ").append(frame).append('\n');
      }
    }
    outbox.say(clock, Word.ERROR, text);
    // The strand may be stuck in the very error: nothing is left to be closed in order.
    Runtime.getRuntime().halt(1);
  }
}
