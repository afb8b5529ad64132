package org.starl.android.app;

import android.bluetooth.BluetoothAdapter;
import android.bluetooth.BluetoothDevice;
import android.bluetooth.BluetoothManager;
import android.bluetooth.BluetoothSocket;
import android.content.Context;
import java.io.IOException;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.starl.robot.create.ByteLink;
import org.starl.robot.create.StreamLink;

/**
 * Links to the serial adapter of one robot, over Bluetooth's serial port profile: each a socket of
 * its own. The adapter must be paired with this phone, which is done in Android's settings.
 */
final class BluetoothLinks implements ByteLink.Source {

  /** The serial port profile's (Bluetooth assigned numbers, 0x1101). */
  static final UUID SERIAL_PORT = UUID.fromString("00001101-0000-1000-8000-00805F9B34FB");

  private final Context context;
  private final String device;

  /**
   * @param device name or address of the paired adapter
   */
  BluetoothLinks(Context context, String device) {
    this.context = context;
    this.device = device;
  }

  @Override
  public ByteLink open() throws IOException {
    try {
      BluetoothSocket socket = paired().createRfcommSocketToServiceRecord(SERIAL_PORT);
      try {
        socket.connect();
        return new StreamLink(
            "the link to Bluetooth device " + device,
            socket.getInputStream(),
            socket.getOutputStream(),
            socket);
      } catch (IOException e) {
        socket.close();
        throw e;
      }
    } catch (SecurityException e) {
      // A person may take the permission back at any time.
      throw new IOException("not allowed to use Bluetooth: grant it in Android's settings", e);
    }
  }

  private BluetoothDevice paired() throws IOException {
    BluetoothAdapter adapter = adapter(context);
    if (adapter == null) {
      throw new IOException("this phone has no Bluetooth");
    }
    if (!adapter.isEnabled()) {
      throw new IOException("Bluetooth is switched off");
    }
    for (BluetoothDevice each : adapter.getBondedDevices()) {
      if (device.equalsIgnoreCase(each.getAddress()) || device.equals(each.getName())) {
        return each;
      }
    }
    throw new IOException(
        "Bluetooth device '" + device + "' is not paired with this phone: pair it in its settings");
  }

  /** The Bluetooth adapter of this phone; null if it has none. */
  static @Nullable BluetoothAdapter adapter(Context context) {
    BluetoothManager manager = context.getSystemService(BluetoothManager.class);
    return manager == null ? null : manager.getAdapter();
  }

  @Override
  public String toString() {
    return "Bluetooth device " + device;
  }
}
