package org.starl.bench;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.id.Participants;
import org.starl.platform.Waits;
import org.starl.primitives.mutex.MutexFact;
import org.starl.primitives.mutex.MutexFailure;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.time.Time;
import org.starl.trace.Instance;

/**
 * The right of way at a four-way stop, for one car: it stands for 2 s, and enters when all cars that
 * stopped before it have entered and have left the zones that it needs. Drivers see each other
 * without an error or a message: the cars of a run share an {@link Junction}.
 */
final class StopSign implements MutexPrim {

  private static final long STOP_NS = 2 * Time.NS_PER_S;

  /** What the drivers at an intersection see. */
  static final class Junction {
    /** In the order of their stops. */
    private final Deque<StopSign> stopped = new ArrayDeque<>();

    private final SortedSet<String> occupied = new TreeSet<>();

    private boolean mayEnter(StopSign car) {
      return stopped.peek() == car && Collections.disjoint(occupied, car.zones);
    }
  }

  private final GlobalVarHolder gvh;
  private final Junction junction;
  private final GvhCell<Boolean> crit;
  private final GvhCell<Boolean> failed;
  private final GvhCell<MutexFailure> failure;
  private final SortedSet<String> zones = new TreeSet<>();
  private long stoppedNs;

  StopSign(GlobalVarHolder gvh, Junction junction) {
    this.gvh = gvh;
    this.junction = junction;
    crit = gvh.variable(source(), MutexFact.CRIT, false);
    failed = gvh.variable(source(), MutexFact.FAILED, false);
    failure = gvh.variable(source(), MutexFact.FAILURE, MutexFailure.NONE);
  }

  @Override
  public void do_mutex(Collection<String> sections) {
    zones.clear();
    zones.addAll(sections);
    stoppedNs = gvh.plat.clock.nowNs();
    junction.stopped.add(this);
  }

  @Override
  public void do_mutex(Collection<String> sections, Participants plist) {
    do_mutex(sections);
  }

  /** Also enters, if it may. */
  @Override
  public MutexFailure acquire(Collection<String> sections, long timeoutMs) {
    throw new UnsupportedOperationException("the cars of this benchmark do not block");
  }

  @Override
  public Waits<MutexFailure> acquiring(Collection<String> sections, long timeoutMs) {
    throw new UnsupportedOperationException("the cars of this benchmark do not wait so");
  }

  @Override
  public List<Occupant> occupants() {
    return List.of();
  }

  @Override
  public boolean od_mutex() {
    boolean hasStood = gvh.plat.clock.nowNs() - stoppedNs >= STOP_NS;
    if (!crit.get() && hasStood && junction.mayEnter(this)) {
      junction.stopped.remove();
      junction.occupied.addAll(zones);
      crit.set(true);
    }
    return crit.get();
  }

  @Override
  public GvhVariable<Boolean> crit() {
    return crit.variable();
  }

  @Override
  public GvhVariable<Boolean> failed() {
    return failed.variable();
  }

  @Override
  public GvhVariable<MutexFailure> failure() {
    return failure.variable();
  }

  @Override
  public void release(Collection<String> sections) {
    List<String> left = new ArrayList<>(sections);
    zones.removeAll(left);
    junction.occupied.removeAll(left);
    crit.set(!zones.isEmpty());
  }

  @Override
  public void withdraw() {
    junction.stopped.remove(this);
  }

  /** No program restarts in these runs. */
  @Override
  public void standsIn(Collection<String> sections) {}

  @Override
  public SortedSet<String> held() {
    return crit.get() ? Collections.unmodifiableSortedSet(zones) : Collections.emptySortedSet();
  }

  @Override
  public Instance source() {
    return Instance.of("stop");
  }

  @Override
  public void close() {
    withdraw();
  }
}
