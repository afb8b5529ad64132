package org.starl.android.app;

import android.content.Context;
import android.net.ConnectivityManager;
import android.net.Network;
import android.net.NetworkCapabilities;

/**
 * The network that carries datagrams now: robots are reached over Wi-Fi or a cable; a phone that
 * prefers mobile data reaches none. It only observes.
 */
final class NetworkWatch extends ConnectivityManager.NetworkCallback {

  /** The phone's kind of connection. */
  enum State {
    NONE("none: switch Wi-Fi on"),
    LOCAL("Wi-Fi or cable"),
    MOBILE("mobile data: switch it off, robots are reached only over Wi-Fi");

    private final String words;

    State(String words) {
      this.words = words;
    }

    @Override
    public String toString() {
      return words;
    }
  }

  private final ConnectivityManager manager;
  private volatile State state = State.NONE;

  NetworkWatch(Context context) {
    manager = context.getSystemService(ConnectivityManager.class);
  }

  void begin() {
    manager.registerDefaultNetworkCallback(this);
  }

  void end() {
    manager.unregisterNetworkCallback(this);
  }

  State state() {
    return state;
  }

  @Override
  public void onCapabilitiesChanged(Network network, NetworkCapabilities capabilities) {
    state =
        capabilities.hasTransport(NetworkCapabilities.TRANSPORT_CELLULAR)
            ? State.MOBILE
            : State.LOCAL;
  }

  @Override
  public void onLost(Network network) {
    state = State.NONE;
  }
}
