package org.starl.primitives.ledger;

import java.util.Collections;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.Persistent;
import org.starl.comms.Channel;
import org.starl.comms.Endpoint;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.agreement.SynodCodec;
import org.starl.primitives.agreement.SynodPrimitive;
import org.starl.primitives.agreement.Value;
import org.starl.shape.Shape;
import org.starl.trace.Instance;

/**
 * The ledger of one robot: {@link LedgerProtocol} on its gvh. A robot that constructs it votes, if it is a
 * voter. Strand only.
 *
 * @param <T> what is to be done; equal ones must be written as equal bytes
 */
public final class TaskLedger<T> extends SynodPrimitive implements LedgerPrim<T> {

  private static final int MAX_WHAT = 200;

  private final Shape<T> shape;
  private final LedgerProtocol protocol;
  private final GvhCell<Boolean> ready;
  private final GvhCell<SortedSet<TaskId>> held;
  private long shown = -1;
  private SortedMap<TaskId, LedgerTask<T>> tasks = new TreeMap<>();

  /** Among all robots of the deployment, which vote. */
  public TaskLedger(GlobalVarHolder gvh, String xid, Shape<T> shape) {
    this(gvh, xid, shape, gvh.id.participants(), LedgerSettings.DEFAULT);
  }

  /**
   * @param xid the instance, at most 31 characters
   * @param shape of what is to be done
   * @param voters the robots that decide, the same on every robot, for ever: a change needs a majority
   *     of them up and in reach. All robots of the deployment may use the ledger
   * @throws IllegalStateException if this start of the robot's program has opened this instance before
   */
  public TaskLedger(
      GlobalVarHolder gvh,
      String xid,
      Shape<T> shape,
      Participants voters,
      LedgerSettings settings) {
    super(
        gvh,
        Instance.of(LedgerFact.PRIMITIVE, xid),
        new Channel<>(LedgerFact.SYNOD, xid, SynodCodec.of(new EntriesFormat(shape))));
    this.shape = shape;
    ready = gvh.variable(source, LedgerFact.READY, false);
    held = gvh.variable(source, LedgerFact.HELD, Collections.emptySortedSet());
    gvh.trace.action(source, LedgerFact.VOTERS, new LedgerFact.Voters(voters.asList()));
    Persistent<LedgerState> stored =
        gvh.plat.persistent("ledger/" + xid, LedgerState.SHAPE, new LedgerState());
    Port port = new Port(stored, xid);
    protocol =
        new LedgerProtocol(
            gvh.id.freshProcess(),
            voters,
            gvh.id.participants(),
            settings,
            gvh.plat.entropy.fork(source.name()),
            wire,
            port,
            gvh.plat.clock.nowNs());
    wire.start(protocol, this::show);
  }

  /**
   * The values and wishes of its decrees.
   *
   * @param what the shape of what is to be done
   */
  record EntriesFormat(Shape<?> what) implements SynodCodec.Format {
    @Override
    public void checkValue(long number, Value value) {
      checkWish(value);
    }

    @Override
    public void checkWish(Value wish) {
      for (LedgerEntry entry : LedgerProtocol.read(wish)) {
        if (entry instanceof LedgerEntry.Add add) {
          add.what().read("a task", what::read);
        }
      }
    }
  }

  @Override
  public GvhVariable<Boolean> ready() {
    return ready.variable();
  }

  @Override
  public SortedMap<TaskId, LedgerTask<T>> tasks() {
    LedgerState state = protocol.state();
    if (protocol.isReady() && shown != state.number()) {
      shown = state.number();
      TreeMap<TaskId, LedgerTask<T>> now = new TreeMap<>();
      state
          .tasks()
          .forEach((id, task) -> {
            T what = task.what().read(source.name(), shape::read);
            now.put(id, new LedgerTask<>(id, what, task.claim(), task.holder(), task.isBegun()));
          });
      tasks = Collections.unmodifiableSortedMap(now);
    }
    return tasks;
  }

  @Override
  public GvhVariable<SortedSet<TaskId>> held() {
    return held.variable();
  }

  @Override
  public long added(String taskSource) {
    return protocol.isReady() ? protocol.state().added(taskSource) : 0;
  }

  @Override
  public LedgerCall add(TaskId task, T what) {
    Value bytes = Value.write(out -> shape.write(what, out));
    if (bytes.length() > MAX_WHAT) {
      throw new IllegalArgumentException(
          source + ": " + task + " of " + bytes.length() + " bytes: expected at most " + MAX_WHAT);
    }
    return want(new LedgerEntry.Add(task, bytes));
  }

  @Override
  public LedgerCall claim(TaskId task) {
    return want(new LedgerEntry.Claim(task, latestClaim(task) + 1, protocol.me()));
  }

  @Override
  public LedgerCall begin(TaskId task) {
    return want(new LedgerEntry.Begin(task, latestClaim(task), protocol.me()));
  }

  @Override
  public LedgerCall finish(TaskId task) {
    return want(new LedgerEntry.Finish(task, latestClaim(task), protocol.me()));
  }

  @Override
  public LedgerCall giveBack(TaskId task) {
    // Claim 0 is none: then there is nothing to give back.
    return want(
        new LedgerEntry.Free(task, isMine(protocol.state().task(task)) ? latestClaim(task) : 0));
  }

  @Override
  public LedgerCall reopen(TaskId task) {
    return want(new LedgerEntry.Reopen(task, latestClaim(task)));
  }

  @Override
  public boolean isSilent(RobotId holder) {
    return protocol.isSilent(holder);
  }

  private long latestClaim(TaskId task) {
    LedgerTask<Value> known = protocol.state().task(task);
    return known == null ? 0 : known.claim();
  }

  private boolean isMine(@Nullable LedgerTask<Value> task) {
    ProcessId holder = task == null ? null : task.holder();
    return holder != null && holder.robot().equals(gvh.id.name());
  }

  private LedgerCall want(LedgerEntry entry) {
    gvh.trace.action(source, LedgerFact.ASKED, new LedgerFact.Asked(entry));
    LedgerCall[] call = new LedgerCall[1];
    wire.call(nowNs -> call[0] = protocol.want(entry, nowNs));
    return call[0];
  }

  private void show() {
    boolean isReady = protocol.isReady();
    ready.set(isReady);
    SortedSet<TaskId> mine = new TreeSet<>();
    if (isReady) {
      protocol
          .state()
          .tasks()
          .forEach((id, task) -> {
            if (isMine(task)) {
              mine.add(id);
            }
          });
    }
    held.set(Collections.unmodifiableSortedSet(mine));
  }

  private final class Port implements LedgerPort {
    private final Persistent<LedgerState> stored;
    private final Endpoint<LedgerMessage> endpoint;
    private boolean hasRefused;

    Port(Persistent<LedgerState> stored, String xid) {
      this.stored = stored;
      endpoint =
          wire.open(
              new Channel<>(LedgerFact.PRIMITIVE, xid, LedgerMessage.SHAPE),
              LedgerMessage::from,
              (message, nowNs) -> protocol.received(message, nowNs));
    }

    @Override
    public void send(RobotId to, LedgerMessage message) {
      endpoint.send(to, message);
    }

    @Override
    public void sendReliably(RobotId to, LedgerMessage message) {
      endpoint.sendReliably(to, message);
    }

    @Override
    public LedgerState stored() {
      return stored.get();
    }

    @Override
    public void store(LedgerState state) {
      stored.set(state);
    }

    @Override
    public void applied(long number, List<LedgerEntry> entries, int count) {
      if (gvh.trace.isOn()) {
        gvh.trace.action(
            source, LedgerFact.APPLIED, new LedgerFact.Applied(number, entries, count));
      }
    }

    @Override
    public void installed(long number, int count) {
      gvh.trace.action(source, LedgerFact.INSTALLED, new LedgerFact.Installed(number, count));
    }

    @Override
    public void check(Value what) {
      what.read("a task", shape::read);
    }

    @Override
    public void refused(ProcessId from, String what) {
      if (!hasRefused) {
        hasRefused = true;
        gvh.log.w(
            source.name(), "dropped from " + from + ": " + what + "; more of these are not told");
      }
    }

    @Override
    public void told(LedgerEntry entry, LedgerOutcome outcome) {
      gvh.trace.action(source, LedgerFact.TOLD, new LedgerFact.Told(entry, outcome));
    }
  }
}
