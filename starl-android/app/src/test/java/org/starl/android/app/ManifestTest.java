package org.starl.android.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Document;
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

  private static Document parsed(String name) throws Exception {
    try (InputStream file = ManifestTest.class.getResourceAsStream("apk/" + name)) {
      return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file);
    }
  }

  @Test
  void noBackupAndNoMoveToAnotherPhoneTakesTheKey() throws Exception {
    Element application =
        (Element) parsed("AndroidManifest.xml").getElementsByTagName("application").item(0);
    assertThat(application.getAttribute("android:allowBackup")).isEqualTo("false");
    assertThat(application.getAttribute("android:dataExtractionRules"))
        .isEqualTo("@xml/data_extraction_rules");
    Document rules = parsed("res/xml/data_extraction_rules.xml");
    for (String way : List.of("cloud-backup", "device-transfer")) {
      Element part = (Element) rules.getElementsByTagName(way).item(0);
      List<String> excluded = new ArrayList<>();
      NodeList domains = part.getElementsByTagName("exclude");
      for (int i = 0; i < domains.getLength(); i++) {
        excluded.add(((Element) domains.item(i)).getAttribute("domain"));
      }
      assertThat(excluded)
          .contains("root", "file", "database", "sharedpref", "external")
          .contains("device_root", "device_file", "device_database", "device_sharedpref");
      assertThat(part.getElementsByTagName("include").getLength()).isZero();
    }
  }

  /** From Android 14 on, high performance is low latency, which needs the screen. */
  @Test
  void theWifiLockHoldsWithTheScreenOffWhereAndroidHasSuchALock() {
    assertThat(List.of(26, 28, 29, 33)).allMatch(sdk -> Locks.wifiMode(sdk) == 3);
    assertThat(List.of(34, 36, 37)).allMatch(sdk -> Locks.wifiMode(sdk) == 4);
  }
}
