package org.starl.apps.intersection.logic;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.id.Participants;
import org.starl.primitives.mutex.M_Mutex;
import org.starl.primitives.mutex.MutexPrim;
import org.starl.primitives.registration.Registration;

/**
 * A post at the side of the road, without wheels. It serves the intersection's registrations as an
 * acceptor, so that cars that come and go agree on who is there. And it takes part in every mutex
 * without ever asking for anything: it is older there than any car, so no car gets in without its
 * consent, and when all who crossed with a car that has crashed are gone, the unit still knows what
 * that car may hold.
 */
public final class RoadsideUnit extends LogicThread {

  private static final long PERIOD_MS = 500;

  private final List<Post> posts = new ArrayList<>();

  /** Its part in one registration and the mutex over it. */
  private static final class Post {
    private final Registration registration;
    private boolean isRegistering;

    Post(GlobalVarHolder gvh, String xid, Participants units) {
      registration = new Registration(gvh, xid, units);
      MutexPrim mutex = new M_Mutex(gvh, xid, registration);
      if (gvh.id.boot() > 1) {
        mutex.standsIn(List.of());
      }
    }

    void look() {
      if (registration.mayRequest()) {
        isRegistering = false;
      } else if (!isRegistering || registration.failed().get()) {
        registration.do_register();
        isRegistering = true;
      }
    }
  }

  /**
   * @param units all roadside units of the intersection, this one among them
   */
  public RoadsideUnit(GlobalVarHolder gvh, String xid, Participants units) {
    super(gvh);
    if (!units.contains(gvh.id.name())) {
      throw new IllegalArgumentException(gvh.id.name() + " is none of the units " + units);
    }
    posts.add(new Post(gvh, xid, units));
    for (int rank = 0; rank < Crossing.PLACES - 1; rank++) {
      posts.add(new Post(gvh, Lane.instance(xid, rank), units));
    }
  }

  /** Stays registered, for as long as it is there. */
  @Override
  public List<Object> callStarL() {
    while (true) {
      posts.forEach(Post::look);
      sleep(PERIOD_MS);
    }
  }
}
