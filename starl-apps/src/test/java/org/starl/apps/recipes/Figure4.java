package org.starl.apps.recipes;

import java.util.LinkedList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.geometry.ItemPosition;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.RegPrim;
import org.starl.primitives.registration.Registration;

/**
 * The paper's Figure 4, line by line, with its braces mended. Four differences:
 *
 * <ul>
 *   <li>{@code plist} is a list of robots: the figure gives it the type of {@code myseq}.
 *   <li>{@code inMotion} is a method.
 *   <li>Nothing is released before the first zone was reached: no car has requested its arrival zone.
 *   <li>S_0, which the figure does not show, registers.
 * </ul>
 *
 * <p>As in the figure, no location handles a failure, and a car that is stopped by a bump releases
 * its zone: {@code IntersectionApp} is the version for real roads.
 */
final class Figure4 extends LogicThread {

  private static final String I_ID = "figure4";

  private enum Location {
    S_0,
    REGISTER_WAIT,
    MUTEX_WAIT,
    MOVE_WAIT,
    S_1,
    DONE
  }

  private final List<ItemPosition> path;
  @Nullable Participants plist;
  LinkedList<ItemPosition> myseq;
  final RegPrim Reg = new Registration(gvh, I_ID);
  final MutexPrim Mutex = new M_Mutex(gvh, I_ID);

  private Location location = Location.S_0;
  private ItemPosition currentDestination;
  private @Nullable ItemPosition preDestination;

  Figure4(GlobalVarHolder gvh, List<ItemPosition> path) {
    super(gvh);
    this.path = path;
    myseq = getMyseq();
    currentDestination = myseq.element();
  }

  @Override
  public List<Object> callStarL() {
    while (location != Location.DONE) {
      switch (location) {
        case S_0:
          Reg.do_register();
          location = Location.REGISTER_WAIT;
          break;
        case REGISTER_WAIT:
          if (Reg.getList() != null) {
            plist = Reg.getList();
            Mutex.do_mutex(myseq, plist);
            location = Location.MUTEX_WAIT;
          }
          break;
        case MUTEX_WAIT:
          if (Mutex.od_mutex()) {
            gvh.plat.moat.doMove(currentDestination);
            location = Location.MOVE_WAIT;
          }
          break;
        case MOVE_WAIT:
          if (!gvh.plat.moat.inMotion()) {
            if (preDestination != null) {
              Mutex.release(CSname(preDestination));
            }
            preDestination = currentDestination;
            myseq.remove();
            if (!myseq.isEmpty()) {
              currentDestination = myseq.peek();
              gvh.plat.moat.doMove(currentDestination);
            } else {
              location = Location.S_1;
            }
          }
          break;
        case S_1:
          if (!gvh.plat.moat.inMotion()) {
            Mutex.release(CSname(preDestination));
            Reg.unregister();
            preDestination = null;
            gvh.plat.moat.motion_stop();
            location = Location.DONE;
          }
          break;
        case DONE:
          break;
      }
      sleep(100);
    }
    return List.of(location, Reg.getList() == null);
  }

  /** The critical zones on the way, then the departure zone. */
  private LinkedList<ItemPosition> getMyseq() {
    return new LinkedList<>(path);
  }

  private static String CSname(ItemPosition zone) {
    return zone.name();
  }
}
