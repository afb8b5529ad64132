package org.starl.android.app;

import android.bluetooth.BluetoothSocket;
import java.io.IOException;
import org.robolectric.annotation.Implementation;
import org.robolectric.annotation.Implements;
import org.robolectric.shadows.ShadowBluetoothSocket;

/** A socket whose close ends pending reads at both ends, as on a phone. */
@Implements(BluetoothSocket.class)
public class SocketShadow extends ShadowBluetoothSocket {

  private volatile boolean isClosed;

  @Implementation
  @Override
  protected void close() throws IOException {
    super.close();
    getInputStreamFeeder().close();
    getOutputStreamSink().close();
    isClosed = true;
  }

  boolean isClosed() {
    return isClosed;
  }

  /** The link breaks. */
  void cut() throws IOException {
    close();
  }
}
