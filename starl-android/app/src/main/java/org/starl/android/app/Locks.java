package org.starl.android.app;

import android.annotation.SuppressLint;
import android.content.Context;
import android.net.wifi.WifiManager;
import android.os.Build;
import android.os.PowerManager;

/**
 * The locks that keep a phone awake while it drives a robot: processor, Wi-Fi without power saving,
 * and multicast, which Wi-Fi drivers drop otherwise. Main thread only.
 */
final class Locks {

  private static final String TAG = "starl:robot";

  private final PowerManager.WakeLock wake;
  private final WifiManager.WifiLock wifi;
  private final WifiManager.MulticastLock multicast;

  Locks(Context context) {
    // The application's: a Wi-Fi manager made for another context leaks it.
    Context application = context.getApplicationContext();
    PowerManager power = application.getSystemService(PowerManager.class);
    WifiManager wifiManager = application.getSystemService(WifiManager.class);
    wake = power.newWakeLock(PowerManager.PARTIAL_WAKE_LOCK, TAG);
    wifi = wifiManager.createWifiLock(wifiMode(Build.VERSION.SDK_INT), TAG);
    multicast = wifiManager.createMulticastLock(TAG);
    wake.setReferenceCounted(false);
    wifi.setReferenceCounted(false);
    multicast.setReferenceCounted(false);
  }

  /**
   * High performance holds with the screen off. From Android 14 on that mode is low latency under its
   * old name, which holds only while the screen is on and the app in front: nothing else is left.
   */
  @SuppressWarnings("deprecation")
  static int wifiMode(int sdk) {
    return sdk >= Build.VERSION_CODES.UPSIDE_DOWN_CAKE
        ? WifiManager.WIFI_MODE_FULL_LOW_LATENCY
        : WifiManager.WIFI_MODE_FULL_HIGH_PERF;
  }

  /** Acquires all, if not held, until {@link #release}, without a timeout. */
  @SuppressLint("WakelockTimeout")
  void acquire() {
    wake.acquire();
    wifi.acquire();
    multicast.acquire();
  }

  /** Releases all that are held. */
  void release() {
    if (multicast.isHeld()) {
      multicast.release();
    }
    if (wifi.isHeld()) {
      wifi.release();
    }
    if (wake.isHeld()) {
      wake.release();
    }
  }

  boolean areHeld() {
    return wake.isHeld() && wifi.isHeld() && multicast.isHeld();
  }
}
