package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The manifest of the APK, a resource of this module. */
class ManifestTest {

  @Test
  void theGuardOfTheWheelsHasAProcessOfItsOwn() throws Exception {
    SortedMap<String, String> processes = new TreeMap<>();
    try (InputStream manifest = getClass().getResourceAsStream("apk/AndroidManifest.xml")) {
      NodeList services =
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(manifest)
              .getElementsByTagName("service");
      for (int i = 0; i < services.getLength(); i++) {
        Element service = (Element) services.item(i);
        assertThat(service.getAttribute("android:exported")).isEqualTo("false");
        processes.put(
            service.getAttribute("android:name"), service.getAttribute("android:process"));
      }
    }
    assertThat(processes)
        .containsEntry("." + RobotService.class.getSimpleName(), "")
        .containsEntry("." + WheelsService.class.getSimpleName(), ":wheels")
        .hasSize(2);
  }
}
