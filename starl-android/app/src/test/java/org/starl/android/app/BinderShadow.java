package org.starl.android.app;

import android.os.Binder;
import android.os.DeadObjectException;
import android.os.IBinder;
import android.os.Parcel;
import android.os.RemoteException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;
import org.robolectric.annotation.RealObject;
import org.robolectric.shadows.ShadowBinder;

/**
 * Binders between a robot and the guard of its wheels, as if the two were processes that die or freeze.
 * Robolectric has one process, and a call runs on the thread of its caller.
 */
@Implements(Binder.class)
public class BinderShadow extends ShadowBinder {

  private static final List<BinderShadow> RECEIVERS = new CopyOnWriteArrayList<>();

  @RealObject private Binder binder;
  private volatile boolean isDead;
  private volatile boolean isFrozen;

  /** The processes of all links so far die: calls fail. Only those at the other end learn of it. */
  static void die() {
    RECEIVERS.forEach(each -> each.isDead = true);
  }

  /** The guards of all links so far freeze: no call has an effect. */
  static void freeze() {
    RECEIVERS.forEach(each -> each.isFrozen = true);
  }

  @Implementation
  @Override
  protected boolean transact(int code, Parcel call, Parcel reply, int flags)
      throws RemoteException {
    if (binder instanceof GuardCalls.Receiver && code != GuardCalls.OPEN) {
      RECEIVERS.add(this);
    }
    if (isDead) {
      throw new DeadObjectException();
    }
    return isFrozen || super.transact(code, call, reply, flags);
  }

  /** Tells the other end that the process of a binder is gone. */
  static void tellDeath(Binder dead) {
    BinderShadow shadow = org.robolectric.shadow.api.Shadow.extract(dead);
    shadow.isDead = true;
    shadow.getDeathRecipients().forEach(IBinder.DeathRecipient::binderDied);
  }
}
