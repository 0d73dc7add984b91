"""The drone's 103 configuration keys: type, category, who may write them, default.

Defaults of limits, rates and codecs are Parrot's (ARDroneLib SDK 2.0.1, config_keys.h). Where the
real default belongs to one machine (serial number, calibration, build date) the value here is a
neutral one of ours. Values are written as on the wire, without the exponent form of floats.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class KeyType(Enum):
    """How a value is written."""

    INT = "int"
    BOOL = "boolean"
    FLOAT = "float"
    DOUBLE = "double"
    TEXT = "string"
    PAIR = "vector of 2"
    VECTOR = "vector of 3"
    MATRIX = "matrix of 3 x 3"


class Category(Enum):
    """Which of the stacked configurations a key lives in."""

    COMMON = "common"
    APPLICATION = "application"
    USER = "user"
    SESSION = "session"


class Access(Enum):
    """When a key may be written: never, without the three ids, only with them, either way."""

    NO = "no"
    DEFAULT = "default configuration"
    IDS = "with ids"
    BOTH = "both"


class ConfigKey(NamedTuple):
    """One key and its facts."""

    name: str
    type: KeyType
    category: Category
    access: Access
    default: str

    @property
    def needs_ids(self) -> bool:
        """Whether writing takes CONFIG_IDS with a session, user and application of one's own."""
        return self.access is Access.IDS

    @property
    def writable(self) -> bool:
        """Whether it can be written at all."""
        return self.access is not Access.NO


INT, BOOL, FLOAT, DOUBLE, TEXT, PAIR, VECTOR, MATRIX = KeyType
COMMON, APPLICATION, USER, SESSION = Category
NO, DEFAULT, IDS, BOTH = Access

KEYS: tuple[ConfigKey, ...] = (
    ConfigKey("general:num_version_config", INT, COMMON, NO, "1"),
    ConfigKey("general:num_version_mb", INT, COMMON, NO, "33"),
    ConfigKey("general:num_version_soft", TEXT, COMMON, NO, "2.4.8"),
    ConfigKey("general:drone_serial", TEXT, COMMON, NO, ""),
    ConfigKey("general:soft_build_date", TEXT, COMMON, NO, "2013-01-01 00:00"),
    ConfigKey("general:motor1_soft", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor1_hard", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor1_supplier", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor2_soft", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor2_hard", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor2_supplier", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor3_soft", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor3_hard", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor3_supplier", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor4_soft", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor4_hard", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:motor4_supplier", TEXT, COMMON, NO, "0.0"),
    ConfigKey("general:ardrone_name", TEXT, COMMON, DEFAULT, "My ARDrone"),
    ConfigKey("general:flying_time", INT, COMMON, NO, "0"),
    ConfigKey("general:navdata_demo", BOOL, COMMON, DEFAULT, "FALSE"),
    ConfigKey("general:navdata_options", INT, APPLICATION, BOTH, "65537"),
    ConfigKey("general:com_watchdog", INT, COMMON, DEFAULT, "2"),
    ConfigKey("general:video_enable", BOOL, COMMON, DEFAULT, "TRUE"),
    ConfigKey("general:vision_enable", BOOL, COMMON, DEFAULT, "TRUE"),
    ConfigKey("general:vbat_min", INT, COMMON, NO, "9000"),
    ConfigKey("control:accs_offset", VECTOR, COMMON, NO, "-2048 2048 2048"),
    ConfigKey("control:accs_gains", MATRIX, COMMON, NO, "1 0 0 0 -1 0 0 0 -1"),
    ConfigKey("control:gyros_offset", VECTOR, COMMON, NO, "1662.5 1662.5 1662.5"),
    ConfigKey("control:gyros_gains", VECTOR, COMMON, NO, "0.001 -0.001 -0.001"),
    ConfigKey("control:gyros110_offset", PAIR, COMMON, NO, "1662.5 1662.5"),
    ConfigKey("control:gyros110_gains", PAIR, COMMON, NO, "0.0001 -0.0001"),
    ConfigKey("control:magneto_offset", VECTOR, COMMON, NO, "0 0 0"),
    ConfigKey("control:magneto_radius", FLOAT, COMMON, NO, "0"),
    ConfigKey("control:gyro_offset_thr_x", FLOAT, COMMON, NO, "4"),
    ConfigKey("control:gyro_offset_thr_y", FLOAT, COMMON, NO, "4"),
    ConfigKey("control:gyro_offset_thr_z", FLOAT, COMMON, NO, "0.5"),
    ConfigKey("control:pwm_ref_gyros", INT, COMMON, NO, "500"),
    ConfigKey("control:osctun_value", INT, COMMON, NO, "63"),
    ConfigKey("control:osctun_test", BOOL, COMMON, NO, "FALSE"),
    ConfigKey("control:control_level", INT, APPLICATION, BOTH, "0"),
    ConfigKey("control:euler_angle_max", FLOAT, USER, BOTH, "0.20943952"),
    ConfigKey("control:altitude_max", INT, COMMON, DEFAULT, "3000"),
    ConfigKey("control:altitude_min", INT, COMMON, DEFAULT, "50"),
    ConfigKey("control:control_iphone_tilt", FLOAT, USER, BOTH, "0.34906584"),
    ConfigKey("control:control_vz_max", FLOAT, USER, BOTH, "700"),
    ConfigKey("control:control_yaw", FLOAT, USER, BOTH, "1.7453293"),
    ConfigKey("control:outdoor", BOOL, COMMON, DEFAULT, "FALSE"),
    ConfigKey("control:flight_without_shell", BOOL, COMMON, DEFAULT, "FALSE"),
    ConfigKey("control:autonomous_flight", BOOL, COMMON, DEFAULT, "FALSE"),
    ConfigKey("control:manual_trim", BOOL, USER, BOTH, "FALSE"),
    ConfigKey("control:indoor_euler_angle_max", FLOAT, USER, BOTH, "0.20943952"),
    ConfigKey("control:indoor_control_vz_max", FLOAT, USER, BOTH, "700"),
    ConfigKey("control:indoor_control_yaw", FLOAT, USER, BOTH, "1.7453293"),
    ConfigKey("control:outdoor_euler_angle_max", FLOAT, USER, BOTH, "0.34906584"),
    ConfigKey("control:outdoor_control_vz_max", FLOAT, USER, BOTH, "1000"),
    ConfigKey("control:outdoor_control_yaw", FLOAT, USER, BOTH, "3.4906585"),
    ConfigKey("control:flying_mode", INT, SESSION, BOTH, "0"),
    ConfigKey("control:hovering_range", INT, SESSION, BOTH, "1000"),
    ConfigKey("control:flight_anim", TEXT, COMMON, DEFAULT, "0,0"),
    ConfigKey("network:ssid_single_player", TEXT, COMMON, DEFAULT, "ardrone2"),
    ConfigKey("network:ssid_multi_player", TEXT, COMMON, DEFAULT, "ardrone2"),
    ConfigKey("network:wifi_mode", INT, COMMON, DEFAULT, "0"),
    ConfigKey("network:wifi_rate", INT, COMMON, DEFAULT, "0"),
    ConfigKey("network:owner_mac", TEXT, COMMON, DEFAULT, "00:00:00:00:00:00"),
    ConfigKey("pic:ultrasound_freq", INT, COMMON, DEFAULT, "8"),
    ConfigKey("pic:ultrasound_watchdog", INT, COMMON, DEFAULT, "3"),
    ConfigKey("pic:pic_version", INT, COMMON, NO, "262192"),
    ConfigKey("video:camif_fps", INT, COMMON, NO, "30"),
    ConfigKey("video:codec_fps", INT, SESSION, IDS, "30"),
    ConfigKey("video:camif_buffers", INT, COMMON, NO, "2"),
    ConfigKey("video:num_trackers", INT, COMMON, NO, "12"),
    ConfigKey("video:video_codec", INT, SESSION, IDS, "129"),
    ConfigKey("video:video_slices", INT, SESSION, IDS, "0"),
    ConfigKey("video:video_live_socket", INT, SESSION, IDS, "0"),
    ConfigKey("video:video_storage_space", INT, COMMON, NO, "0"),
    ConfigKey("video:bitrate", INT, APPLICATION, IDS, "1000"),
    ConfigKey("video:max_bitrate", INT, SESSION, IDS, "1000"),
    ConfigKey("video:bitrate_ctrl_mode", INT, APPLICATION, IDS, "0"),
    ConfigKey("video:bitrate_storage", INT, APPLICATION, IDS, "4000"),
    ConfigKey("video:video_channel", INT, SESSION, BOTH, "0"),
    ConfigKey("video:video_on_usb", BOOL, COMMON, BOTH, "TRUE"),
    ConfigKey("video:video_file_index", INT, COMMON, BOTH, "1"),
    ConfigKey("leds:leds_anim", TEXT, COMMON, DEFAULT, "0,0,0"),
    ConfigKey("detect:enemy_colors", INT, COMMON, DEFAULT, "1"),
    ConfigKey("detect:groundstripe_colors", INT, SESSION, BOTH, "16"),
    ConfigKey("detect:enemy_without_shell", INT, COMMON, DEFAULT, "0"),
    ConfigKey("detect:detect_type", INT, SESSION, BOTH, "3"),
    ConfigKey("detect:detections_select_h", INT, SESSION, BOTH, "0"),
    ConfigKey("detect:detections_select_v_hsync", INT, SESSION, BOTH, "0"),
    ConfigKey("detect:detections_select_v", INT, SESSION, BOTH, "0"),
    ConfigKey("syslog:output", INT, COMMON, DEFAULT, "7"),
    ConfigKey("syslog:max_size", INT, COMMON, DEFAULT, "102400"),
    ConfigKey("syslog:nb_files", INT, COMMON, DEFAULT, "5"),
    ConfigKey("userbox:userbox_cmd", TEXT, SESSION, BOTH, "0"),
    ConfigKey("gps:latitude", DOUBLE, SESSION, BOTH, "500"),
    ConfigKey("gps:longitude", DOUBLE, SESSION, BOTH, "500"),
    ConfigKey("gps:altitude", DOUBLE, SESSION, BOTH, "0.0"),
    ConfigKey("custom:application_id", TEXT, SESSION, BOTH, "00000000"),
    ConfigKey(
        "custom:application_desc", TEXT, APPLICATION, BOTH, "Default application configuration"
    ),
    ConfigKey("custom:profile_id", TEXT, SESSION, BOTH, "00000000"),
    ConfigKey("custom:profile_desc", TEXT, USER, BOTH, ".Primary Profile"),
    ConfigKey("custom:session_id", TEXT, SESSION, BOTH, "00000000"),
    ConfigKey("custom:session_desc", TEXT, SESSION, BOTH, "Default session configuration"),
)
