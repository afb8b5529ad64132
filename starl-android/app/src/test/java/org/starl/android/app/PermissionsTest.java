package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;

import android.Manifest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PermissionsTest {

  @ParameterizedTest
  @ValueSource(ints = {26, 29, 30})
  void upToAndroid11NoPermissionIsRequested(int sdk) {
    assertThat(Permissions.asked(sdk, 36)).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(ints = {31, 32})
  void android12AndLaterRequestBluetooth(int sdk) {
    assertThat(Permissions.asked(sdk, 36)).containsExactly(Manifest.permission.BLUETOOTH_CONNECT);
  }

  @ParameterizedTest
  @ValueSource(ints = {33, 36, 37})
  void android13AndLaterRequestTheOptionalNotificationPermission(int sdk) {
    assertThat(Permissions.asked(sdk, 36))
        .containsExactly(
            Manifest.permission.BLUETOOTH_CONNECT, Manifest.permission.POST_NOTIFICATIONS);
    assertThat(Permissions.required(sdk, 36))
        .containsExactly(Manifest.permission.BLUETOOTH_CONNECT);
  }

  @Test
  void theLocalNetworkIsRequestedIfTheAppTargetsAndroid17() {
    assertThat(Permissions.required(37, 37)).contains(Permissions.ACCESS_LOCAL_NETWORK);
    assertThat(Permissions.required(36, 37)).doesNotContain(Permissions.ACCESS_LOCAL_NETWORK);
  }
}
