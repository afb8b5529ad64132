package org.starl.apps.intersection;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.apps.intersection.logic.Crossing;
import org.starl.apps.intersection.logic.CrossingFact;
import org.starl.apps.intersection.logic.CrossingFact.Way;
import org.starl.apps.intersection.logic.IntersectionApp.Location;
import org.starl.apps.intersection.logic.Trip;
import org.starl.geometry.ItemPosition;
import org.starl.gvh.GvhCell;
import org.starl.id.ProcessId;
import org.starl.motion.MotionFlag;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.mutex.MutexFact;
import org.starl.trace.Instance;

/** A car with one planted bug, which writes the same trace events as a correct car. */
final class BuggyCar extends LogicThread {

  private static final Instance MUTEX = Instance.of(MutexFact.PRIMITIVE, "crossing");

  /** The planted bug. */
  enum Fault {
    /** Drives without asking the mutex. */
    DOES_NOT_ASK,
    /** Has a mutex that grants at once, even if other cars are inside. */
    GRANTS_ITSELF,
    /** Releases a zone as soon as it has reached its middle. */
    RELEASES_TOO_EARLY,
    /** Stands at the head of its arm for ever. */
    NEVER_LEAVES
  }

  private final Fault fault;
  private final Trip trip;
  private final ProcessId id;
  private final GvhCell<Location> location;
  private final GvhCell<List<String>> myseq;
  private List<String> held = List.of();

  BuggyCar(GlobalVarHolder gvh, Trip trip, Fault fault) {
    super(gvh);
    this.fault = fault;
    this.trip = trip;
    id = gvh.id.freshProcess();
    gvh.trace.action(Way.SHAPE, Way.of(trip, trip.zones()));
    location = gvh.variable(CrossingFact.LOCATION, Location.S_0);
    myseq = gvh.variable(CrossingFact.MYSEQ, trip.zones());
    gvh.plat.moat.setParameters(Crossing.motion(gvh.plat.moat.parameters()));
  }

  @Override
  public List<Object> callStarL() {
    await(gvh.gps::hasFix);
    await(() -> fault != Fault.NEVER_LEAVES);
    if (fault != Fault.DOES_NOT_ASK) {
      held = trip.zones();
      SortedSet<ProcessId> known = new TreeSet<>(List.of(id));
      tell(new MutexFact.DoMutex(id, 1, 1, Sections.copyOf(held), known));
      tell(new MutexFact.OdMutex(id, 1, Sections.copyOf(held)));
    }
    location.set(Location.MOVE_WAIT);
    for (ItemPosition station : trip.stations()) {
      driveTo(station);
      List<String> left = new ArrayList<>(myseq.get());
      left.remove(station.name());
      myseq.set(List.copyOf(left));
      if (fault == Fault.RELEASES_TOO_EARLY) {
        release(left);
      }
    }
    location.set(Location.S_1);
    driveTo(trip.exit());
    if (!held.isEmpty()) {
      release(List.of());
    }
    gvh.plat.moat.motion_stop();
    location.set(Location.DONE);
    return List.of();
  }

  private void driveTo(ItemPosition target) {
    gvh.plat.moat.doMove(target);
    while (gvh.plat.moat.motionflag().get() != MotionFlag.DONE) {
      if (gvh.plat.moat.motionflag().get() == MotionFlag.FAIL) {
        sleep(1000);
        gvh.plat.moat.doMove(target);
      }
      sleep(100);
    }
  }

  private void release(List<String> left) {
    List<String> given = new ArrayList<>(held);
    given.removeAll(left);
    held = List.copyOf(left);
    tell(new MutexFact.Release(id, 1, Sections.copyOf(given), Sections.copyOf(held)));
  }

  private void tell(MutexFact fact) {
    gvh.trace.action(MUTEX, MutexFact.SHAPE, fact);
  }
}
