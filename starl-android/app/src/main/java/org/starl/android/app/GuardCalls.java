package org.starl.android.app;

import android.os.Binder;
import android.os.IBinder;
import android.os.Parcel;
import android.os.RemoteException;

/**
 * The calls between a robot's process and that of its {@link WheelsService}. All are one-way, so that no
 * process waits for the other; those to one binder arrive in their order.
 */
final class GuardCalls {

  /**
   * To the service: opens a link to the Create. Binder of the client, text of the port, ms for which
   * a command is valid.
   */
  static final int OPEN = IBinder.FIRST_CALL_TRANSACTION;

  /** To the link: time in ns, bytes for the Create. */
  static final int WRITE = OPEN + 1;

  /** To the link: stop the wheels and close it. */
  static final int CLOSE = OPEN + 2;

  /** To the client: binder of the link, id of its process. */
  static final int OPENED = OPEN + 3;

  /** To the client: bytes of the Create. */
  static final int READ = OPEN + 4;

  /** To the client: the link is closed, or was not opened; the reason as text. */
  static final int ENDED = OPEN + 5;

  private static final String DESCRIPTOR = "org.starl.android.app.GuardCalls";

  private GuardCalls() {}

  /** Writes the parameters of a call. */
  interface Parameters {
    void write(Parcel call);
  }

  /**
   * Sends a call.
   *
   * @throws RemoteException if the other process is gone, or takes no calls
   */
  static void send(IBinder to, int code, Parameters parameters) throws RemoteException {
    Parcel call = Parcel.obtain();
    try {
      call.writeInterfaceToken(DESCRIPTOR);
      parameters.write(call);
      to.transact(code, call, null, IBinder.FLAG_ONEWAY);
    } finally {
      call.recycle();
    }
  }

  /** Receives calls, on any thread. */
  abstract static class Receiver extends Binder {

    /** Takes a call that this class knows. */
    abstract void receive(int code, Parcel call);

    @Override
    protected final boolean onTransact(int code, Parcel call, Parcel reply, int flags)
        throws RemoteException {
      if (code < OPEN || code > ENDED) {
        return super.onTransact(code, call, reply, flags);
      }
      call.enforceInterface(DESCRIPTOR);
      receive(code, call);
      return true;
    }
  }
}
