plugins {
    `java-library`
}

description = "Robots whose base is a ROS 2 node: a service of the real platform; plain JVM"

dependencies {
    api(project(":starl-android-robot"))
    // Fast DDS for Java. Of its own libraries only those that it uses here.
    implementation(libs.ihmc.pub.sub)
    api(libs.jspecify)
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

configurations.all {
    exclude("us.ihmc", "log-tools")
    exclude("org.apache.logging.log4j")
    exclude("org.slf4j")
}

tasks.withType<Test>().configureEach {
    jvmArgs("--enable-native-access=ALL-UNNAMED")
}
