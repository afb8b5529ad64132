package org.starl.primitives.chaos;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodLink;
import org.starl.primitives.agreement.SynodMessage;
import org.starl.primitives.agreement.SynodProtocol;
import org.starl.shape.RecordShape;
import org.starl.shape.Shape;
import org.starl.shape.SumShape;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** One robot of a {@link LiveWorld}: its disk, which survives, and its program, which may not. */
public abstract class LiveRobot {

  private static final int DATAGRAM_BYTES = 1400;

  private final LiveWorld<? extends LiveRobot> world;
  private final Instance source;
  public final RobotId name;
  private byte @Nullable [] disk;
  private int boot;
  private @Nullable Program program;

  /** Whether writes are said to be stable before they are, and lost. */
  public boolean diskForgets;

  protected LiveRobot(LiveWorld<? extends LiveRobot> world, Instance source, RobotId name) {
    this.world = world;
    this.source = source;
    this.name = name;
  }

  /** Creates the program, with its acceptor's last record. */
  protected abstract Program program(ProcessId me);

  public boolean isUp() {
    return program != null;
  }

  /** The program; it must be up. */
  public Program running() {
    Program up = program;
    if (up == null) {
      throw new IllegalStateException(name + " is down");
    }
    return up;
  }

  public void start() {
    boot++;
    if (boot > 1) {
      fault(TraceEvent.Fault.RESTART);
    }
    Program begun = program(ProcessId.first(name, boot));
    program = begun;
    begun.settle();
  }

  public void crash() {
    program = null;
    fault(TraceEvent.Fault.CRASH);
  }

  private void fault(String what) {
    world.record(new TraceEvent.Fault(world.nowNs(), name, what, ""));
  }

  /** One run of the robot's program. */
  public abstract class Program implements SynodLink {

    private final Shape<SynodMessage> synodCodec;
    private final Map<String, Object> shown = new TreeMap<>();
    private long timerSetForNs = Long.MAX_VALUE;
    private long lastFlushNs;

    protected Program(Shape<SynodMessage> synodCodec) {
      this.synodCodec = synodCodec;
    }

    protected abstract SynodProtocol protocol();

    /** Shows all variables, through {@link #show}. */
    protected abstract void settled();

    /** An input from outside. */
    public void call(Runnable input) {
      input.run();
      settle();
    }

    /** A variable's value, which the trace sees if it differs from the one before. */
    protected <T> void show(Var<T> variable, T value) {
      if (!value.equals(shown.put(variable.name(), value))) {
        world.record(new TraceEvent.Variable(world.nowNs(), name, source, variable, value));
      }
    }

    protected <F> void act(RecordShape<F> shape, F fact) {
      world.record(TraceEvent.Action.of(world.nowNs(), name, source, shape, fact));
    }

    protected <F> void act(SumShape<F> shape, F fact) {
      world.record(TraceEvent.Action.of(world.nowNs(), name, source, shape, fact));
    }

    /** Sends over wire and network; {@code handler} runs on the receiver's program, if it is up. */
    protected <M> void transmit(
        RobotId to, M message, Shape<M> codec, BiConsumer<Program, M> handler) {
      M read = overTheWire(message, codec);
      LiveRobot receiver = world.robot(to);
      world.transmit(name, to, () -> receiver.arrived(read, handler));
    }

    protected <M> void broadcast(M message, Shape<M> codec, BiConsumer<Program, M> handler) {
      for (LiveRobot other : world.robots) {
        if (other != LiveRobot.this) {
          transmit(other.name, message, codec, handler);
        }
      }
    }

    @Override
    public byte @Nullable [] record() {
      byte[] written = disk;
      return diskForgets || written == null ? null : written.clone();
    }

    @Override
    public void send(RobotId to, SynodMessage message) {
      transmit(
          to,
          message,
          synodCodec,
          (program, m) -> program.protocol().received(name, m, world.nowNs()));
    }

    @Override
    public void persist(long version, byte[] record) {
      long flushMs = world.rng.nextLong(0, world.weather.maxFlushMs());
      lastFlushNs = Math.max(lastFlushNs, world.nowNs() + flushMs * LiveWorld.NS_PER_MS);
      byte[] written = record.clone();
      world.at(
          lastFlushNs,
          () -> {
            if (isCurrent()) {
              disk = written;
              call(() -> protocol().flushed(version, world.nowNs()));
            }
          });
    }

    private boolean isCurrent() {
      return program == this;
    }

    private void settle() {
      settled();
      long wakeAtNs = protocol().wakeAtNs();
      if (wakeAtNs != timerSetForNs) {
        timerSetForNs = wakeAtNs;
        if (wakeAtNs != Long.MAX_VALUE) {
          world.at(wakeAtNs, () -> expired(wakeAtNs));
        }
      }
    }

    private void expired(long setForNs) {
      if (isCurrent() && timerSetForNs == setForNs) {
        timerSetForNs = Long.MAX_VALUE;
        call(() -> protocol().timer(world.nowNs()));
      }
    }
  }

  private <M> void arrived(M message, BiConsumer<Program, M> handler) {
    Program up = program;
    if (up != null) {
      up.call(() -> handler.accept(up, message));
    }
  }

  private static <M> M overTheWire(M message, Shape<M> codec) {
    byte[] buffer = new byte[DATAGRAM_BYTES];
    WireWriter out = new WireWriter(buffer);
    codec.write(message, out);
    WireReader in = new WireReader(Arrays.copyOf(buffer, out.length()));
    M read = codec.read(in);
    if (in.remaining() != 0 || !read.equals(message)) {
      throw new IllegalStateException(message + " came back as " + read);
    }
    return read;
  }
}
